import type { ComponentChildren } from "preact";

type Part = string | preact.JSX.Element;

/** A longer text is shown in one colour: thousands of pieces are slow to draw, and to keep up with typing. */
const LONGEST = 60_000;

/**
 * Cuts a text at the matches of `pattern`, whose named groups are the kinds of tokens. No markup is ever made from
 * the text itself.
 */
export function tokens(text: string, pattern: RegExp): ComponentChildren {
  if (text.length > LONGEST) return text;
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
