// Prints [file, line, name] of each declaration in ui/src as JSON, for names.py.

import { readdirSync, readFileSync } from "node:fs"
import { createRequire } from "node:module"
import { join } from "node:path"

const ui = join(import.meta.dirname, "..", "ui")
const src = join(ui, "src")
const ts = createRequire(join(ui, "package.json"))("typescript")
const found = []

/** Declarations have a `name`. So have keys of object literals, whose properties often have no declared type. */
function visit(file, source, node) {
  if (node.name && (ts.isIdentifier(node.name) || ts.isPrivateIdentifier(node.name)) && !isUse(node)) {
    const { line } = source.getLineAndCharacterOfPosition(node.name.getStart(source))
    found.push([file, line + 1, node.name.text.replace(/^#/, "")])
  }
  ts.forEachChild(node, (child) => visit(file, source, child))
}

/** `a.name`, `{ name }` of a value and `import { name }` are uses of another declaration. */
function isUse(node) {
  return (
    ts.isPropertyAccessExpression(node) ||
    ts.isShorthandPropertyAssignment(node) ||
    ts.isMetaProperty(node) ||
    ts.isJsxAttribute(node) ||
    (ts.isImportSpecifier(node) && !node.propertyName) ||
    (ts.isExportSpecifier(node) && !node.propertyName)
  )
}

for (const file of readdirSync(src, { recursive: true }).filter((name) => /\.tsx?$/.test(name))) {
  const source = ts.createSourceFile(file, readFileSync(join(src, file), "utf8"), ts.ScriptTarget.Latest, true)
  visit(file.replaceAll("\\", "/"), source, source)
}
console.log(JSON.stringify(found))
