// The page's side of a learning platform, as cmake/web/make_page.py puts it into the page.
"use strict";
const fs = require("node:fs"), path = require("node:path");
module.exports = ["cmi5.js", "platform.js"].map((file) => fs.readFileSync(path.join(__dirname, "../../app/web", file), "utf8")).join("");
