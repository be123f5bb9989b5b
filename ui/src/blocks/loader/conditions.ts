import type { Expression } from "../generator/document";

/**
 * The original's condition strings, such as `result == "B"`, parsed to the tree that the server's reader makes of them
 * (pinel_desktop/program/conditions.py, where the grammar is).
 */
export function parseCondition(text: string): Expression {
  return new Parser(tokensOf(text)).parse();
}

/** The text is no condition. */
export class ConditionError extends Error {}

interface Token {
  kind: "text" | "number" | "word" | "sign" | "logic" | "end";
  value: string;
}

const TOKEN =
  /[ \t]*(?:(?<text>"[^"]*"|'[^']*')|(?<number>[+-]?(?:[0-9]{1,300}(?:\.[0-9]{0,300})?|\.[0-9]{1,300}))(?![\p{L}\p{N}_.])|(?<word>[A-Za-z_]+)(?![\p{L}\p{N}_.])|(?<sign>==|!=|<=|>=|&&|\|\||[<>!()]))/uy;

const WORDS: Readonly<Record<string, string>> = {
  and: "and",
  or: "or",
  not: "not",
  "&&": "and",
  "||": "or",
  "!": "not",
};
const COMPARISONS = ["==", "!=", "<=", ">=", "<", ">"];
const MAX_NESTING = 64;

function tokensOf(text: string): Token[] {
  const tokens: Token[] = [];
  const end = text.replace(/[ \t]+$/, "").length;
  TOKEN.lastIndex = 0;
  while (TOKEN.lastIndex < end) {
    const match = TOKEN.exec(text);
    const found = Object.entries(match?.groups ?? {}).find(([, value]) => value !== undefined);
    if (!found) throw new ConditionError(text);
    const [kind, value] = found as [Token["kind"], string];
    tokens.push({ kind: Object.hasOwn(WORDS, value) ? "logic" : kind, value });
  }
  tokens.push({ kind: "end", value: "" });
  return tokens;
}

class Parser {
  private index = 0;
  private depth = 0;

  constructor(private readonly tokens: readonly Token[]) {}

  parse(): Expression {
    const tree = this.joined("or");
    if (this.next.kind !== "end") throw this.unexpected();
    return tree;
  }

  private get next(): Token {
    return this.tokens[this.index] as Token;
  }

  private take(): Token {
    return this.tokens[this.index++] as Token;
  }

  private unexpected(): ConditionError {
    return new ConditionError(this.next.value);
  }

  private atLogic(word: string): boolean {
    return this.next.kind === "logic" && WORDS[this.next.value] === word;
  }

  private joined(word: "or" | "and"): Expression {
    const part = () => (word === "or" ? this.joined("and") : this.negated());
    const parts = [part()];
    while (this.atLogic(word)) {
      this.take();
      parts.push(part());
    }
    return parts.length === 1 ? (parts[0] as Expression) : { op: word, args: parts };
  }

  private negated(): Expression {
    if (!this.atLogic("not")) return this.comparison();
    return this.deeper(() => ({ op: "not", args: [this.negated()] }));
  }

  private comparison(): Expression {
    const left = this.operand();
    if (this.next.kind !== "sign" || !COMPARISONS.includes(this.next.value)) return left;
    const op = this.take().value;
    return { op, args: [left, this.operand()] };
  }

  private operand(): Expression {
    const { kind, value } = this.next;
    if (kind === "text") return this.take().value.slice(1, -1);
    if (kind === "number") return Number(this.take().value);
    if (kind === "word" && ["result", "resultado"].includes(value)) {
      this.take();
      return { gesture: "result" };
    }
    if (kind === "sign" && value === "(") return this.deeper(() => this.group());
    throw this.unexpected();
  }

  private group(): Expression {
    const tree = this.joined("or");
    if (this.next.kind !== "sign" || this.next.value !== ")") throw this.unexpected();
    this.take();
    return tree;
  }

  /** Takes the sign that leads a level down, and comes back. */
  private deeper(read: () => Expression): Expression {
    if (++this.depth > MAX_NESTING) throw this.unexpected();
    this.take();
    const tree = read();
    this.depth--;
    return tree;
  }
}
