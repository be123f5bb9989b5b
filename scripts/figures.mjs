// Prints the page's structure as JSON for figures.py: pairs [importer, imported] of files, and the lines of each component.
// Includes imports of types and lazy imports by import("..."); omits files that only a glob names.

import { readdirSync, readFileSync } from "node:fs"
import { createRequire } from "node:module"
import { dirname, join, relative } from "node:path"

const ui = join(import.meta.dirname, "..", "ui")
const src = join(ui, "src")
const ts = createRequire(join(ui, "package.json"))("typescript")
const files = readdirSync(src, { recursive: true }).filter((name) => /\.tsx?$/.test(name) && !/\.test\./.test(name))
const known = new Set(files)
const imports = []
const components = []

function target(file, specifier) {
  const path = relative(src, join(src, dirname(file), specifier))
  return [path, `${path}.ts`, `${path}.tsx`, `${path}/index.ts`, `${path}/index.tsx`].find((name) => known.has(name))
}

function visit(file, source, node) {
  const specifier = specifierOf(node)
  const imported = specifier?.startsWith(".") && target(file, specifier)
  if (imported) imports.push([file, imported])
  const named = ts.isFunctionDeclaration(node) || (ts.isVariableDeclaration(node) && isFunction(node.initializer))
  if (named && /^[A-Z]/.test(node.name?.text ?? "") && file.endsWith(".tsx")) {
    const [from, to] = [node.getStart(source), node.getEnd()].map((at) => source.getLineAndCharacterOfPosition(at).line)
    components.push([`${file}: ${node.name.text}`, to - from + 1])
  }
  ts.forEachChild(node, (child) => visit(file, source, child))
}

/** Returns the path in `import ... from "..."`, `export ... from "..."` and `import("...")`. */
function specifierOf(node) {
  if (ts.isImportDeclaration(node) || ts.isExportDeclaration(node)) return node.moduleSpecifier?.text
  const isLater = ts.isCallExpression(node) && node.expression.kind === ts.SyntaxKind.ImportKeyword
  return isLater ? node.arguments[0].text : undefined
}

function isFunction(node) {
  return node !== undefined && (ts.isArrowFunction(node) || ts.isFunctionExpression(node))
}

for (const file of files) {
  const source = ts.createSourceFile(file, readFileSync(join(src, file), "utf8"), ts.ScriptTarget.Latest, true)
  visit(file, source, source)
}
console.log(JSON.stringify({ imports, components }))
