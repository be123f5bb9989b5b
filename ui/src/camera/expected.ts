import { isSameSign } from "../blocks/known_signs";

type Tree = { readonly [key: string]: unknown } | readonly unknown[];

const isTree = (value: unknown): value is Tree => typeof value === "object" && value !== null;
const COMPARING = new Set(["==", "!="]);

/** All objects in a document, in the order of the document. */
function* within(node: unknown): Generator<Record<string, unknown>> {
  if (!isTree(node)) return;
  if (!Array.isArray(node)) yield node as Record<string, unknown>;
  for (const value of Object.values(node)) yield* within(value);
}

const CAPTURES: ReadonlySet<unknown> = new Set(["classify_gestures", "read_number"]);

/** Whether the document has a command that waits for a sign or a number. */
export function hasCapture(document: unknown): boolean {
  return [...within(document)].some(({ action }) => CAPTURES.has(action));
}

/** Maximum length of an answer that the server accepts, in characters. */
const MAX_SIGN_LENGTH = 100;

/**
 * The signs that a program compares the result of a capture with, in the order of the document. The
 * result may be compared directly or by way of a variable.
 */
export function expectedSigns(document: unknown): string[] {
  const nodes = [...within(document)];
  const assignments = nodes.filter(
    (node) => node.action === "set_variable" && isResult(node.value),
  );
  const names = new Set(assignments.map(({ name }) => name));
  const isAnswer = (value: unknown) =>
    isResult(value) || (isTree(value) && "var" in value && names.has(value.var));
  const signs = nodes
    .filter(
      ({ op, args }) => COMPARING.has(String(op)) && Array.isArray(args) && args.some(isAnswer),
    )
    .flatMap(({ args }) => args as unknown[])
    .filter((value): value is string => typeof value === "string" && value.trim() !== "")
    .filter((name) => name.length <= MAX_SIGN_LENGTH)
    .map((name) => (name.length === 1 ? name.toUpperCase() : name));
  return signs.filter((one, at) => signs.findIndex((other) => isSameSign(one, other)) === at);
}

const isResult = (value: unknown) =>
  isTree(value) && "gesture" in value && value.gesture === "result";
