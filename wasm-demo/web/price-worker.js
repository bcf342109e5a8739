// Answers what a light costs, off the page's thread.
import { words } from "./failure.js";
import init, { survey } from "./price/luminaire_price.js";

const ready = init();

onmessage = async ({ data }) => {
  try {
    await ready;
    postMessage({ survey: JSON.parse(survey(data)) });
  } catch (refusal) {
    // The module refuses with a string.
    postMessage(typeof refusal === "string" ? { refusal } : { failure: words(refusal) });
  }
};
