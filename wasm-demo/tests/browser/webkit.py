#!/usr/bin/python3
"""A WebKitGTK browser for tests: windows of any size without decoration, which WebKitWebDriver opens.

MiniBrowser, which comes with WebKitGTK, has a toolbar that makes windows at least 447 pixels wide,
and runs no scripts before those of a page.

Argument: a folder. Of it, `prelude.js` runs at the start of every page. What happens in the windows
is appended to `log.jsonl`, one JSON value in a line.
"""

import json
import pathlib
import sys

import gi

gi.require_version("Gtk", "3.0")
gi.require_version("WebKit2", "4.1")
from gi.repository import Gtk, WebKit2

FOLDER = pathlib.Path(sys.argv[1])
# Posts what a page complains of; the console itself is not told to embedders.
WATCH = """(() => {
  const tell = (...words) => window.webkit.messageHandlers.complaint.postMessage(words.map(String).join(" "));
  const { error, assert } = console;
  console.error = (...words) => { tell(...words); error.apply(console, words); };
  console.assert = (holds, ...words) => { if (!holds) tell(...words); assert.call(console, holds, ...words); };
  addEventListener("error", (event) => tell(event.error ?? event.message));
  addEventListener("unhandledrejection", (event) => tell(event.reason));
  addEventListener("securitypolicyviolation", (event) => tell(event.violatedDirective, event.blockedURI));
})();
"""

windows = 0


def log(window, what, text):
    with open(FOLDER / "log.jsonl", "a", encoding="utf-8") as file:
        file.write(json.dumps({"window": window, what: text}) + "\n")


def open_window(_session, context):
    global windows
    number, windows = windows, windows + 1
    content = WebKit2.UserContentManager()
    content.register_script_message_handler("complaint")
    content.connect(
        "script-message-received::complaint",
        lambda _, result: log(number, "complaint", result.get_js_value().to_string()),
    )
    prelude = WATCH + (FOLDER / "prelude.js").read_text(encoding="utf-8")
    frames, start = WebKit2.UserContentInjectedFrames.TOP_FRAME, WebKit2.UserScriptInjectionTime.START
    content.add_script(WebKit2.UserScript(prelude, frames, start, None, None))
    view = WebKit2.WebView(
        web_context=context, is_controlled_by_automation=True, user_content_manager=content
    )
    view.connect("resource-load-started", watch_resource, number)
    window = Gtk.Window(decorated=False, default_width=1440, default_height=900)
    view.connect("close", lambda _: window.destroy())
    window.add(view)
    window.show_all()
    return view


def watch_resource(_view, resource, request, number):
    def finished(resource):
        response = resource.get_response()
        if response and response.get_status_code() >= 400:
            log(number, "complaint", f"{response.get_status_code()} {resource.get_uri()}")

    def failed(resource, error):
        # The browser itself cancels a page that it loads again in another process.
        if not error.matches(WebKit2.network_error_quark(), WebKit2.NetworkError.CANCELLED):
            log(number, "complaint", f"{error.message} {resource.get_uri()}")

    log(number, "request", request.get_uri())
    resource.connect("finished", finished)
    resource.connect("failed", failed)


def start(_context, session):
    info = WebKit2.ApplicationInfo()
    info.set_name("WebKitGTK")
    info.set_version(
        WebKit2.get_major_version(), WebKit2.get_minor_version(), WebKit2.get_micro_version()
    )
    session.set_application_info(info)
    session.connect("create-web-view", open_window, context)


context = WebKit2.WebContext.new_ephemeral()
context.set_automation_allowed(True)
context.connect("automation-started", start)
Gtk.main()
