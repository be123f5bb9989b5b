import type { ComponentChildren } from "preact";

type Part = string | preact.JSX.Element;

/** Longer texts are not coloured: thousands of elements are slow to draw and to update. */
const MAX_COLOURED_LENGTH = 60_000;

/**
 * Splits a text into tokens at the matches of `pattern`, whose named groups are token types. The text is never parsed as
 * markup.
 */
export function tokens(text: string, pattern: RegExp): ComponentChildren {
  if (text.length > MAX_COLOURED_LENGTH) return text;
  const parts: Part[] = [];
  let end = 0;
  for (const match of text.matchAll(pattern)) {
    const found = Object.entries(match.groups ?? {}).find(([, value]) => value !== undefined);
    if (!found) continue;
    const [kind, value = ""] = found;
    parts.push(text.slice(end, match.index), <span class={`token--${kind}`}>{value}</span>);
    end = match.index + value.length;
  }
  parts.push(text.slice(end));
  return parts;
}

export const JSON_TOKENS =
  /(?<name>"(?:[^"\\]|\\.)*"(?=\s*:))|(?<text>"(?:[^"\\]|\\.)*")|(?<number>-?\d+(?:\.\d+)?(?:e[-+]?\d+)?)/gi;

export const PYTHON_TOKENS = new RegExp(
  [
    "(?<comment>#.*)",
    String.raw`(?<text>"""[\s\S]*?(?:"""|$)|"(?:[^"\\\n]|\\.)*"?|'(?:[^'\\\n]|\\.)*'?)`,
    String.raw`(?<number>\b\d+(?:\.\d+)?(?:e[-+]?\d+)?\b)`,
    String.raw`(?<word>\b(?:and|break|continue|def|elif|else|False|for|global|if|in|not|or|pass|return|True|while)\b)`,
  ].join("|"),
  "g",
);
