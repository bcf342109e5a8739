// Addresses as other programs pass them on.

/** A state with every sign that an address of the page has. */
export const STATE = "v=1&scene=three-point&view=-0.5/0/1.2&lights=0:b12:cffcc00_1:x_2:opower/0.1/0.2/0.2/3&effects=-dither&play=none";
export const LINK = `#stage?${STATE}`;

/**
 * What mail filters, chats, editors and trackers make of an address.
 * @type {Record<string, (link: string) => string>}
 */
export const CHANGES = {
  "as it was": (link) => link,
  "without #": (link) => link.slice(1),
  "signs escaped": (link) => link.replace(/[:/;_]/g, (sign) => `%${sign.charCodeAt(0).toString(16).toUpperCase()}`),
  "signs escaped, in lower case": (link) => link.replace(/[:/;_]/g, (sign) => `%${sign.charCodeAt(0).toString(16)}`),
  "all signs escaped": (link) => encodeURIComponent(link),
  "escaped twice": (link) => encodeURIComponent(encodeURIComponent(link)),
  "escaped by two filters": (link) => encodeURIComponent(link.replaceAll("&", "&amp;")),
  "equals signs escaped": (link) => link.replaceAll("=", "%3D"),
  "question mark escaped": (link) => link.replace("?", "%3F"),
  "as HTML": (link) => link.replaceAll("&", "&amp;"),
  "as HTML, twice": (link) => link.replaceAll("&", "&amp;amp;"),
  "as HTML, by decimals": (link) => link.replaceAll("&", "&#38;").replaceAll("=", "&#61;"),
  "as HTML, by hexadecimals": (link) => link.replaceAll("&", "&#x26;").replaceAll("/", "&#x2F;"),
  "as the source of a mail": (link) => link.replaceAll("=", "=3D"),
  "broken by a mail": (link) => link.replace(/(.{40})/g, "$1\r\n"),
  "broken by a mail, escaped": (link) => link.replace(/(.{40})/g, "$1%0D%0A%20"),
  "with invisible signs to break at": (link) => link.replace(/([&/])/g, "$1\u200b").replace("three", "th\u00adree"),
  "with hyphens as dashes": (link) => link.replace("-0.5", "\u22120.5").replace("three-", "three\u2011").replace("-dither", "\u2013dither"),
  "with a byte order mark": (link) => `\ufeff${link}`,
  ...Object.fromEntries([".", ",", ";", ":", "!", "?", ")", "]", "}", ">", "\"", "'", "\u2019", "\u00bb", "\u3002", "*", "**", "_", "~", "|", "&gt;", "%22", "...", ").", "\\"].map((end) => [`with ${end} at the end`, (link) => link + end])),
  "with a parameter": (link) => `${link}&fbclid=IwAR0`,
  "with parameters before": (link) => link.replace("?", "?utm_source=mail&utm_medium=x&"),
  "with a parameter as to an address without a state": (link) => `${link}?fbclid=IwAR0`,
  "with a second fragment": (link) => `${link}#top`,
};
