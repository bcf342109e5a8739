// Opens the demo, or tells why not. Everything else is imported from within, so that a file that is missing is told, too.
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
