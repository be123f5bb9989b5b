import { existsSync, readdirSync, readFileSync } from "node:fs";
import { describe, expect, test } from "vitest";
import { manualOf, NAMES } from "../../manual_pages";
import type { ManualElement, ManualNode } from "./model";

const FILES = NAMES.flatMap((name) => [
  [name, `../docs/${name}.pt-BR.md`] as const,
  [name, `../docs/${name}.md`] as const,
]);
const read = (path: string) => readFileSync(path, "utf8");

/** All elements of a manual with the given tag. */
function elements(nodes: readonly ManualNode[], tag: string): ManualElement[] {
  return nodes.flatMap((node) =>
    typeof node === "string"
      ? []
      : [...(node.tag === tag ? [node] : []), ...elements(node.children, tag)],
  );
}

const bodyOf = (markdown: string) =>
  manualOf("install", `# Title\n\n${markdown}`).sections.flatMap(({ nodes }) => nodes);

describe("a page as a manual", () => {
  test("begins with its title and is cut at its headings", () => {
    const { title, sections } = manualOf("trust", "# A *b*\n\nc\n\n## Não é só d?\n\ne\n\n### F\n");
    expect(title).toBe("A b");
    expect(sections).toEqual([
      { id: "", title: "", nodes: [{ tag: "p", children: ["c"] }] },
      {
        id: "nao-e-so-d",
        title: "Não é só d?",
        nodes: [
          { tag: "p", children: ["e"] },
          { tag: "h3", id: "f", children: ["F"] },
        ],
      },
    ]);
  });

  test("HTML is text, and comments are left out", () => {
    expect(bodyOf("a <script>b</script> <!-- c\nd -->e")).toEqual([
      { tag: "p", children: ["a <script>b</script> e"] },
    ]);
  });

  test("links lead to manuals; the text of all others stays", () => {
    const links = bodyOf(
      "[a](trust.pt-BR.md) [b](keeping.md#é-isso) [c](#d) [e](events.md) [f](https://example.org) [g](../x.py)",
    );
    expect(elements(links, "a").map(({ href }) => href)).toEqual([
      "#/manuals/trust",
      "#/manuals/keeping/e-isso",
      "#/manuals/install/d",
    ]);
    expect(JSON.stringify(links)).toContain('" ","e"," ","f"," ","g"');
  });

  test("the link to the same page in another language is left out", () => {
    expect(bodyOf("[In English](install.md)\n\na")).toEqual([{ tag: "p", children: ["a"] }]);
  });

  test("a head of a table that is empty is no head", () => {
    const table = bodyOf("| | a |\n|---|---|\n| b | c |");
    expect(elements(table, "th").map(({ children }) => children)).toEqual([["a"]]);
    expect(elements(table, "td")).toHaveLength(3);
  });

  test("what the page cannot draw stops the build", () => {
    expect(() => bodyOf("> quoted")).toThrow("install: the page draws no blockquote_open");
  });
});

describe.each(FILES)("%s: %s", (name, path) => {
  const manual = manualOf(name, read(path));
  const nodes = manual.sections.flatMap((section) => section.nodes);

  test("has text under each heading, and an address for each", () => {
    expect(manual.sections.filter(({ nodes }) => nodes.length === 0)).toEqual([]);
    const ids = [...manual.sections, ...elements(nodes, "h3")].map(({ id }) => id);
    expect(new Set(ids).size).toBe(ids.length);
  });

  test("its pictures are there and have a text", () => {
    const pictures = elements(nodes, "img");
    expect(pictures.filter(({ alt }) => !alt)).toEqual([]);
    const files = pictures.map(({ src }) => src?.replace("picture:", "../docs/") ?? "");
    expect(files.filter((file) => !existsSync(file))).toEqual([]);
  });

  test("its links lead to headings that are there", () => {
    const ending = path.endsWith(".pt-BR.md") ? ".pt-BR.md" : ".md";
    const broken = elements(nodes, "a")
      .map(({ href = "" }) => href.split("/").slice(2))
      .filter(([target = "", id]) => {
        const { sections } = manualOf(target, read(`../docs/${target}${ending}`));
        const h3 = elements(
          sections.flatMap((section) => section.nodes),
          "h3",
        );
        return id && ![...sections, ...h3].some((heading) => heading.id === id);
      });
    expect(broken).toEqual([]);
  });
});

test("each page of docs/ in Portuguese is a manual", () => {
  const portuguese = readdirSync("../docs").filter((file) => file.endsWith(".pt-BR.md"));
  expect(portuguese.map((file) => file.replace(".pt-BR.md", "")).sort()).toEqual([...NAMES].sort());
});
