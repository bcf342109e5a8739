// Opens the demo, or shows why it can't. Everything else is imported dynamically, so that a missing
// file is reported, too.
import { fail, watch } from "./failure.js";
import { load, requireSimd } from "./support.js";

watch();
try {
  requireSimd();
  const { open } = await load("show.js");
  await open();
  document.body.dataset.state = "ready";
} catch (error) {
  fail(error);
}
