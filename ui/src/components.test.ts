import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import ts from "typescript";
import { expect, test } from "vitest";

const MAX_LINES = 60;

/** Lists the components of a file, each with its number of lines. */
function read(path: string): [string, number][] {
  const text = readFileSync(join("src", path), "utf8");
  const source = ts.createSourceFile(path, text, ts.ScriptTarget.Latest, true);
  const components: [string, number][] = [];
  const lineAt = (at: number) => source.getLineAndCharacterOfPosition(at).line;
  const visit = (node: ts.Node): void => {
    const name = nameOf(node);
    if (name && /^[A-Z]/.test(name)) {
      components.push([`${path} ${name}`, lineAt(node.end) - lineAt(node.getStart()) + 1]);
    }
    ts.forEachChild(node, visit);
  };
  visit(source);
  return components;
}

/** The name of a function, from its declaration or from its constant. */
function nameOf(node: ts.Node): string | undefined {
  if (ts.isFunctionDeclaration(node)) return node.name?.text;
  const { parent } = node;
  const isFunction = ts.isArrowFunction(node) || ts.isFunctionExpression(node);
  if (isFunction && ts.isVariableDeclaration(parent)) return parent.name.getText();
  return undefined;
}

test(`no component is longer than ${MAX_LINES} lines`, () => {
  const files = readdirSync("src", { recursive: true, encoding: "utf8" });
  const components = files
    .filter((path) => path.endsWith(".tsx") && !path.endsWith(".test.tsx"))
    .flatMap(read);
  expect(components.length).toBeGreaterThan(200);
  expect(components.filter(([, lines]) => lines > MAX_LINES)).toEqual([]);
});
