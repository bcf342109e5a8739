// Opens the demo, or shows why it can't. Everything else is imported dynamically, so that a missing
// file is reported, too.
import { element } from "./elements.js";
import { fail, watch } from "./failure.js";
import { load, requireSimd } from "./support.js";

watch();
// The poster is the first scene.
element("poster").hidden = !["", "#stage"].includes(location.hash);
try {
  requireSimd();
  const { open } = await load("show.js");
  await open();
  document.body.dataset.state = "ready";
} catch (error) {
  fail(error);
}
