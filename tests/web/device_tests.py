"""HID devices in the page: a browser's WebHID with devices that are scripts, and everything after it as it is."""

from page import PAGE, PageTest

# navigator.hid with one device that is shown when it is asked for. What it is sent is kept.
FAKE = """
class FakeDevice extends EventTarget {
  opened = false;
  sent = [];
  constructor(productName, vendorId, productId, usagePage, usage, features) {
    super();
    Object.assign(this, {productName, vendorId, productId, features});
    this.collections = [{usagePage, usage, featureReports: Object.keys(features).map((id) => ({reportId: Number(id)}))}];
  }
  async open() { this.opened = true; }
  async close() { this.opened = false; }
  async receiveFeatureReport(id) { return new DataView(Uint8Array.from(this.features[id]).buffer); }
  async sendReport(id, data) { this.sent.push([id, ...data]); }
  report(id, bytes) {
    this.dispatchEvent(Object.assign(new Event("inputreport"),
                                     {reportId: id, data: new DataView(Uint8Array.from(bytes).buffer), device: this}));
  }
}
const u16 = (...all) => all.flatMap((v) => [v & 255, v >> 8 & 255]);
// 5 um, 3.3 N, 1 N for good, 200 x 160 x 120 mm, 1000 N/m, damping 3 N s/m, most 5 N s/m, friction 0.1 N, 1 ms.
const description = [3, 77, 76, 84, 67, 1, ...u16(5000, 3300, 1000, 200, 160, 120, 1000, 3000, 5000, 100, 1000), 0, 0, 0, 0];
globalThis.fakes = {
  open: new FakeDevice("Bench stylus", 0x1209, 1, 0xFF00, 1, {3: description}),
  space: new FakeDevice("SpaceMouse Compact", 0x256f, 0xc635, 1, 8, {}),
};
class FakeHid extends EventTarget {
  asked = [];
  async getDevices() { return []; }
  async requestDevice(options) {
    this.asked.push({filters: options.filters, gesture: navigator.userActivation.isActive});
    return [fakes[globalThis.shows]];
  }
}
Object.defineProperty(Navigator.prototype, "hid", {value: new FakeHid()});
// Places of the stylus, 1000 a second, also those of the time in which the page was busy: mm, at no more than 0.5 m/s.
globalThis.hand = [0, 0, 45];
globalThis.at = [...hand];
globalThis.play = () => {
  const begun_ms = performance.now();
  let number = 0;
  setInterval(() => {
    for (const due = performance.now() - begun_ms; number < due; ) {
      ++number;
      hand.forEach((wanted, k) => { at[k] += Math.max(-0.5, Math.min(0.5, wanted - at[k])); });
      const place = at.map((mm) => Math.round(mm * 200) & 0xffff);
      fakes.open.report(1, [...u16(number), 0, 0, 0, 0, ...u16(...place), ...u16(0, 0, 0, 32767), 0, 0, ...u16(0)]);
    }
  }, 1);
};
"""


class Devices(PageTest):
    def device_page(self, browser):
        browser.hold("ControlLeft", True, "Control", 2)
        browser.key("KeyD", "d", 2)
        browser.hold("ControlLeft", False, "Control")

    def show(self, browser, which, driver, title):
        browser.evaluate(f"globalThis.shows = '{which}'")
        self.device_page(browser)
        browser.wait_for("device/ask")
        browser.click("device/ask")
        # Listed among those to choose: with its place, which one that is not there has none of.
        browser.wait_for(f"device/{driver}/place", "webhid")
        browser.click(f"device/{driver}")
        browser.wait_for("device/name", title)
        browser.frames(20)

    def hand_mm(self, browser):
        told = browser.text("device/live").replace("\u00a0", " ").replace("\u2212", "-")
        return [float(v) for v in told.split("at ")[1].split(" mm")[0].split(", ")]

    def goes_in(self, browser):
        """True when the force has gone out while the atom was touched."""
        browser.evaluate("hand[2] = 0")
        browser.until("at[2] === 0")
        for place_mm in range(-1, -50, -1):
            browser.evaluate(f"hand[2] = {place_mm}")
            browser.frames(2)
            state = browser.text("view/state") or ""
            if "inside" in state:
                return False
            if "touching" in state and browser.evaluate(
                    "fakes.open.sent.some((r) => r[0] === 2 && ((r[7] | r[8] << 8) << 16 >> 16) > 20)"):
                return True
        return False

    def test_a_device_of_the_open_layout_is_shown_by_a_click_leads_the_probe_and_is_given_force_that_pushes_it_out(self):
        browser = self.browser(script=FAKE, width=960, height=700)  # fewer pixels: more frames a second
        self.open_lesson(browser)
        self.show(browser, "open", "open", "Bench stylus")
        asked = browser.evaluate("navigator.hid.asked")
        self.assertEqual(len(asked), 1)
        self.assertTrue(asked[0]["gesture"], "a browser would have refused")
        self.assertIn({"usagePage": 0xFF00, "usage": 1}, asked[0]["filters"])
        browser.evaluate("play()")
        browser.frames(30)
        for got, wanted in zip(self.hand_mm(browser), (0, 0, 45)):
            self.assertAlmostEqual(got, wanted, delta=0.6)
        self.picture(browser, "device")
        browser.key("Escape")
        browser.frames(5)
        # Moves slowly toward the atom until it is touched, and slightly further. If frames are too slow to keep a contact,
        # the page reports this, and the hand moves out and in again.
        for _ in range(8):
            if self.goes_in(browser):
                break
            browser.evaluate("hand[2] = 45")
            browser.until("at[2] === 45")
            browser.frames(10)
        browser.wait_for("task/0", "done", patience_s=10)
        sent = browser.evaluate("fakes.open.sent")
        forces = [[int.from_bytes(bytes(r[3 + 2 * k:5 + 2 * k]), "little", signed=True) for k in range(3)]
                  for r in sent if r[0] == 2]
        self.assertGreater(len(forces), 20)
        # Toward the person, never more than the device bears for good, and with its watchdog of 50 ms.
        self.assertGreater(max(f[2] for f in forces), 0)
        self.assertGreaterEqual(min(f[2] for f in forces), 0)
        self.assertLessEqual(max(sum(c * c for c in f) ** 0.5 for f in forces), 3300)
        self.assertEqual({r[10] for r in sent if r[0] == 2}, {50})
        # The page is put away: the last report has no force, and the motors off.
        browser.evaluate("Object.defineProperty(document, 'hidden', {value: true, configurable: true});"
                         "document.dispatchEvent(new Event('visibilitychange')); fakes.open.sent.at(-1)")
        last = browser.evaluate("fakes.open.sent.findLast((r) => r[0] === 2 && r[9] === 0)")
        self.assertEqual(last[3:10], [0] * 7)
        self.no_errors(browser)

    def test_a_device_that_is_unplugged_gives_the_hand_back_to_the_mouse_and_tells_so(self):
        browser = self.browser(script=FAKE)
        self.open_lesson(browser)
        self.show(browser, "open", "open", "Bench stylus")
        browser.evaluate("play()")
        browser.frames(20)
        browser.evaluate("navigator.hid.dispatchEvent(Object.assign(new Event('disconnect'), {device: fakes.open}))")
        browser.until("Object.values(JSON.parse(moltact.ccall('moltact_widgets','string',[],[])))"
                      ".some((w) => w[4].includes('is unplugged'))", 30)
        browser.key("Escape")
        self.press(browser, until=("task/0", "done"))

    def test_a_SpaceMouse_pushed_to_the_right_moves_the_hand_to_the_right(self):
        browser = self.browser(script=FAKE)
        self.open_lesson(browser)
        self.show(browser, "space", "spacemouse", "SpaceMouse")
        before = self.hand_mm(browser)
        # 350 is its stop: for about a second.
        for _ in range(30):
            browser.evaluate("fakes.space.report(1, [...u16(350, 0, 0)])")
            browser.frames(2)
        browser.evaluate("fakes.space.report(1, [...u16(0, 0, 0)])")
        browser.frames(10)
        after = self.hand_mm(browser)
        self.assertGreater(after[0] - before[0], 5.0)
        self.assertAlmostEqual(after[1], before[1], delta=0.5)
        self.assertEqual(browser.evaluate("fakes.space.sent"), [])
        self.no_errors(browser)

    def test_a_device_whose_description_is_wrong_is_listed_with_the_reason_and_not_chosen(self):
        browser = self.browser(script=FAKE + "description[6] = description[7] = 0; fakes.open.features[3] = description;")
        self.open_lesson(browser)
        browser.evaluate("globalThis.shows = 'open'")
        self.device_page(browser)
        browser.wait_for("device/ask")
        browser.click("device/ask")
        browser.wait_for("device/open/why", "its place's unit (byte 6) is 0", patience_s=30)
        self.no_errors(browser)
