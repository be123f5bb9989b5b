import MarkdownIt, { type Token } from "markdown-it";
import {
  MANUAL_TAGS,
  type Manual,
  type ManualElement,
  type ManualNode,
  type ManualTag,
} from "./src/manuals/model.ts";

/** The pages of docs/ that the page shows, in the order of its list. The others are for developers. */
export const NAMES = [
  "teacher",
  "lesson",
  "robots",
  "install",
  "kiosk",
  "keeping",
  "trust",
] as const;

/**
 * A manual from its text in Markdown. HTML in it is text like any other. Throws at a construct that the page does not
 * draw, which stops the build.
 */
export function manualOf(name: string, markdown: string): Manual {
  const [first, ...nodes] = treeOf(tokensOf(name, markdown), name);
  if (typeof first !== "object" || first.tag !== "h1") throw new Error(`${name}: no title`);
  const sections: Manual["sections"] = [{ id: "", title: "", nodes: [] }];
  for (const node of nodes) {
    if (typeof node === "object" && node.tag === "h2") {
      sections.push({ id: node.id ?? "", title: textOf(node), nodes: [] });
    } else sections.at(-1)?.nodes.push(node);
  }
  return { name, title: textOf(first), sections: sections.filter(({ nodes }) => nodes.length > 0) };
}

/** The tokens of a page, without comments and without its link to the same page in another language. */
function tokensOf(name: string, markdown: string): Token[] {
  const text = markdown
    .replace(/<!--[\s\S]*?-->/g, "")
    .replace(new RegExp(`^\\[[^\\]]+\\]\\(${name}[\\w.-]*\\.md\\)$`, "m"), "");
  return new MarkdownIt({ html: false }).parse(text, {});
}

interface OpenElement extends Omit<ManualElement, "tag"> {
  /** Without a tag, the content takes the place of the element. */
  tag: ManualTag | null;
}

/** The elements of a list of tokens, which tells begin and end of each element. */
function treeOf(tokens: readonly Token[], name: string): ManualNode[] {
  const open: OpenElement[] = [{ tag: null, children: [] }];
  for (const token of tokens) {
    if (token.nesting === 1) open.push(elementOf(token, name));
    else if (token.nesting === -1) {
      const done = open.pop();
      if (done) open.at(-1)?.children.push(...closed(done));
    } else open.at(-1)?.children.push(...leavesOf(token, name));
  }
  return open[0]?.children ?? [];
}

function elementOf(token: Token, name: string): OpenElement {
  const tag = MANUAL_TAGS.find((one) => one === token.tag);
  if (!tag) throw new Error(`${name}: the page draws no ${token.type}`);
  if (token.type === "link_open") {
    const href = addressOf(String(token.attrGet("href") ?? ""), name);
    return href ? { tag: "a", href, children: [] } : { tag: null, children: [] };
  }
  return { tag: token.hidden ? null : tag, children: [] };
}

function closed({ tag, ...element }: OpenElement): ManualNode[] {
  if (tag === null) return element.children;
  if (tag === "th" && element.children.length === 0) return [{ tag: "td", children: [] }]; // heads no column
  const node: ManualElement = { tag, ...element };
  return [/^h[23]$/.test(tag) ? { ...node, id: headingId(textOf(node)) } : node];
}

function leavesOf(token: Token, name: string): ManualNode[] {
  const { type, content } = token;
  if (type === "inline") return treeOf(token.children ?? [], name);
  if (type === "text") return content ? [content] : [];
  if (type === "softbreak") return [" "];
  if (type === "code_inline") return [{ tag: "code", children: [content] }];
  if (type === "fence") return [{ tag: "pre", children: [content.trimEnd()] }];
  if (type === "image") {
    return [
      { tag: "img", src: `picture:${token.attrGet("src")}`, alt: token.content, children: [] },
    ];
  }
  throw new Error(`${name}: the page draws no ${type}`);
}

/** The address of a linked manual in the page; null for all else, which the page does not have. */
function addressOf(target: string, name: string): string | null {
  const [whole, file, anchor] = /^(?:([\w-]+)(?:\.pt-BR)?\.md)?(?:#(.+))?$/.exec(target) ?? [];
  const manual = file ?? name;
  if (!whole || !NAMES.some((one) => one === manual)) return null;
  const id = anchor ? `/${headingId(decodeURIComponent(anchor))}` : "";
  return `#/manuals/${manual}${id}`;
}

/** The id of a heading in an address, in ASCII. */
const headingId = (title: string): string =>
  title
    .normalize("NFD")
    .replace(/\p{M}/gu, "")
    .toLowerCase()
    .replace(/[^\w -]/g, "")
    .replace(/ /g, "-");

function textOf(node: ManualNode): string {
  return typeof node === "string" ? node : node.children.map(textOf).join("");
}
