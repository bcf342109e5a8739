// The rules for the scripts of the demo's page.
import js from "@eslint/js";

export default [
  js.configs.recommended,
  // TypeScript knows the names of browsers and workers.
  { rules: { "no-undef": "off" } },
];
