// Reports that a script of the page was not loaded. Not a module, because browsers load no module
// from a file.
addEventListener(
  "error",
  ({ target }) => {
    if (!(target instanceof HTMLScriptElement)) return;
    const place = /** @type {HTMLElement} */ (document.getElementById("failure"));
    place.textContent =
      location.protocol === "file:"
        ? "This page was opened as a file, and from files browsers load no modules. " +
          "Run `cargo demo` in the project's folder, and open the address that it names."
        : `${target.src}, or a file that it needs, could not be loaded. Serve the whole folder over HTTP, and reload the page.`;
    place.hidden = false;
    document.body.dataset.state = "failed";
  },
  true,
);
