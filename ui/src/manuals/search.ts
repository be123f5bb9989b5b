import { matchesAll, tokenize } from "../blocks/toolbox/search";
import { withCommand } from "../shell/command";
import type { Manual, ManualNode, ManualSection } from "./model";

/** A section of a manual that has all words of a query. */
export interface ManualHit {
  readonly manual: Manual;
  readonly section: ManualSection;
  /** A paragraph from its sentence with most of the words on. */
  readonly excerpt: string;
}

/** Elements whose text is read without that of their neighbours. */
const PARAGRAPHS = ["p", "li", "tr", "pre", "h3"];

/** The sections that have all words of the query, or words that begin with them; those with them in their heading first. */
export function searchManuals(manuals: readonly Manual[], query: string): ManualHit[] {
  const terms = tokenize(query);
  if (terms.length === 0) return [];
  return manuals
    .flatMap((manual) => manual.sections.map((section) => hitOf(manual, section, terms)))
    .filter(({ rank }) => rank > 0)
    .sort((one, other) => other.rank - one.rank);
}

function hitOf(manual: Manual, section: ManualSection, terms: readonly string[]) {
  const paragraphs = section.nodes.flatMap(paragraphsOf);
  return {
    manual,
    section,
    rank: rankOf(manual, section, paragraphs, terms),
    excerpt: excerptOf(paragraphs, terms),
  };
}

function rankOf(
  manual: Manual,
  section: ManualSection,
  paragraphs: readonly string[],
  terms: readonly string[],
): number {
  if (matchesAll(section.title || manual.title, terms)) return 3;
  if (matchesAll(`${section.title} ${manual.title}`, terms)) return 2;
  return matchesAll([section.title, ...paragraphs].join(" "), terms) ? 1 : 0;
}

function excerptOf(paragraphs: readonly string[], terms: readonly string[]): string {
  const endings = paragraphs.flatMap((paragraph) => {
    const sentences = paragraph.split(/(?<=[.:;?!])\s+/);
    return sentences.map((sentence, index) => ({
      n: terms.filter((term) => matchesAll(sentence, [term])).length,
      text: sentences.slice(index).join(" "),
    }));
  });
  const most = Math.max(...endings.map(({ n }) => n));
  return endings.find(({ n }) => n === most)?.text ?? "";
}

function paragraphsOf(node: ManualNode): string[] {
  if (typeof node === "string") return [node];
  if (PARAGRAPHS.includes(node.tag)) return [textOf(node)];
  return node.children.flatMap(paragraphsOf);
}

/** The text of an element; cells of a table are set apart. */
function textOf(node: ManualNode): string {
  if (typeof node === "string") return node;
  const text = node.children.map(textOf).join(node.tag === "tr" ? " · " : "");
  return node.tag === "code" || node.tag === "pre" ? withCommand(text) : text;
}
