// Opens a page in Chromium for a command of the laboratory: standard input has the request and its acts as JSON, and
// standard output gets what was found.
import { text } from "node:stream/consumers";

import { visit } from "./visit.mjs";

const { acts, ...request } = JSON.parse(await text(process.stdin));
console.log(JSON.stringify(await visit(request, acts)));
