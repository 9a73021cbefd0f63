// Access to HID devices by WebHID, for engine/device/hid/hid_port_web.cpp, which reads and writes them within a frame.
// The reports since the last frame are distributed evenly over the frame's ticks. Of several writes in a frame, the
// last of each kind is sent. `stir` requests frames.
function moltactDevices(stir) {
  "use strict";
  const kOpenLayout = {usagePage: 0xFF00, usage: 1};
  const kFilters = [kOpenLayout, {vendorId: 0x046d, usagePage: 1, usage: 8}, {vendorId: 0x256f, usagePage: 1, usage: 8}];
  const kMaxWaiting = 128, kMaxTicks = 100, kPatience_ms = 1000;
  const known = new Map();  // by path: {device, features}
  const ports = new Map();  // by number
  let last_port = 0, last_path = 0;

  // The id is first if the device numbers its reports; some browsers insert it themselves.
  function withId(id, view) {
    const bytes = new Uint8Array(view.buffer, view.byteOffset, view.byteLength);
    return id ? Uint8Array.of(id, ...bytes) : bytes.slice();
  }

  async function add(device) {
    if ([...known.values()].some((one) => one.device === device)) return;
    try {
      if (!device.opened) await device.open();
      const features = new Map();
      for (const part of device.collections) {
        if (part.usagePage !== kOpenLayout.usagePage || part.usage !== kOpenLayout.usage) continue;
        for (const {reportId} of part.featureReports || []) {
          const view = await device.receiveFeatureReport(reportId);
          features.set(reportId, withId(view.byteLength && view.getUint8(0) === reportId ? 0 : reportId, view));
        }
      }
      device.addEventListener("inputreport", (event) => {
        const report = withId(event.reportId, event.data);
        for (const port of ports.values()) {
          if (port.device !== device) continue;
          port.queue.push(report);
          if (port.queue.length > kMaxWaiting) port.queue.shift();
        }
        stir();
      });
      known.set("webhid:" + ++last_path, {device, features});
      stir();
    } catch (error) {
      console.warn(device.productName + ": " + error);
    }
  }

  function lose(device) {
    for (const [path, one] of known) if (one.device === device) known.delete(path);
    for (const port of ports.values()) if (port.device === device) port.gone = true;
    stir();
  }

  async function send(port) {
    if (port.sending) return;
    port.sending = true;
    try {
      while (port.waiting.size) {
        const [[id, bytes]] = port.waiting;
        port.waiting.delete(id);
        await port.device.sendReport(id, bytes.subarray(1));
      }
    } catch {
      port.gone = true;
    }
    port.sending = false;
  }

  // A hidden page gets no frames, so the force is stopped.
  function rest() {
    for (const port of ports.values())
      if (port.final && !port.gone) port.device.sendReport(port.final[0], port.final.subarray(1)).catch(() => {});
  }

  return {
    there: () => Boolean(navigator.hid),

    // Devices that the user has allowed for this page before, including earlier visits.
    async begin() {
      if (!navigator.hid) return;
      navigator.hid.addEventListener("connect", (event) => add(event.device));
      navigator.hid.addEventListener("disconnect", (event) => lose(event.device));
      document.addEventListener("visibilitychange", () => { if (document.hidden) rest(); });
      addEventListener("pagehide", rest);
      try {
        const before = navigator.hid.getDevices().then((all) => Promise.all(all.map(add)));
        await Promise.race([before, new Promise((done) => setTimeout(done, kPatience_ms))]);
      } catch (error) {
        console.warn(String(error));
      }
    },

    ask() {
      if (navigator.hid) navigator.hid.requestDevice({filters: kFilters}).then((all) => all.forEach(add)).catch(() => {});
    },

    list() {
      const entries = [];
      for (const [path, {device}] of known)
        for (const part of device.collections)
          entries.push({path, title: device.productName, vendor: device.vendorId, product: device.productId,
                        usage_page: part.usagePage, usage: part.usage});
      return JSON.stringify(entries);
    },

    open(path) {
      const one = known.get(path);
      if (!one) return -1;
      ports.set(++last_port, {device: one.device, features: one.features, queue: [], waiting: new Map(), sending: false,
                              gone: false, final: null, share: 0, credit: 0, begins: true});
      return last_port;
    },

    close(number) { ports.delete(number); },

    // Called before the ticks of a frame of this duration: distributes the received reports over them.
    deal(dt_s) {
      const ticks = Math.max(1, Math.min(kMaxTicks, Math.round(1000 * dt_s)));
      for (const port of ports.values()) {
        port.share = port.queue.length / ticks;
        port.credit = 0.5;  // round instead of truncating
        port.begins = true;
      }
    },

    // Returns a report; null: no more for this tick; undefined: the device is gone.
    read(number) {
      const port = ports.get(number);
      if (port.gone) return undefined;
      if (port.begins) port.credit += port.share;
      port.begins = port.credit < 1 || !port.queue.length;
      if (port.begins) return null;
      port.credit -= 1;
      return port.queue.shift();
    },

    feature(number, id) { return ports.get(number).features.get(id); },

    write(number, bytes) {
      const port = ports.get(number);
      if (port.gone) return false;
      port.waiting.set(bytes[0], bytes);
      Promise.resolve().then(() => send(port));
      return true;
    },

    last(number, bytes) { ports.get(number).final = bytes; },
  };
}
