import type {
  Branch,
  Command,
  Expression,
  FunctionDefinition,
  Literal,
  ProgramDocument,
} from "../../generator/document";
import { SENSOR_ROWS } from "../../table/sensor_rows";

/**
 * Generates random documents without faults that use the whole language; a seed always gives the
 * same documents.
 */
export class RandomPrograms {
  private state: number;
  private readonly functions: FunctionDefinition[] = [];
  private ids = 0;
  private inLoop = false;
  private inFunction = false;

  constructor(seed: number) {
    this.state = seed >>> 0;
  }

  document(): ProgramDocument {
    for (let count = this.whole(3); count > 0; count--) this.functions.push(this.signature(count));
    this.inFunction = true;
    for (const definition of this.functions) {
      definition.commands = [...this.commands(3), this.named({ action: "return", value: 1 })];
    }
    this.inFunction = false;
    return {
      pinel_ir: 1,
      name: "acaso",
      functions: this.functions,
      commands: this.commands(4),
    };
  }

  private signature(number: number): FunctionDefinition {
    const parameters = ["lado", "ângulo é", "n_2"].slice(0, this.whole(4));
    return {
      name: `função ${number}`,
      parameters,
      commands: [],
      block: this.id(),
      ...this.maybe({ comment: "faz o quê?" }),
    };
  }

  private commands(depth: number): Command[] {
    return Array.from({ length: this.whole(5) }, () => this.command(depth));
  }

  private command(depth: number): Command {
    const makers = depth > 0 ? [...this.simple, ...this.nested(depth - 1)] : this.simple;
    return this.named(this.pick(makers)());
  }

  private named(command: Command): Command {
    const comment = this.maybe({ comment: 'um "comentário"\nem duas linhas' });
    return { ...command, block: this.id(), ...comment };
  }

  /**
   * The last command of a body; `break` and `continue` in loops only, `return` in functions only.
   */
  private ending(): Command {
    const endings: Command[] = [{ action: "beep" }];
    if (this.inLoop) endings.push({ action: "break" }, { action: "continue" });
    if (this.inFunction)
      endings.push({ action: "return" }, { action: "return", value: this.any(2) });
    return this.pick(endings);
  }

  private body(depth: number): Command[] {
    const before = this.inLoop;
    this.inLoop = true;
    const commands = this.commands(depth);
    this.inLoop = before;
    return commands;
  }

  private readonly simple: (() => Command)[] = [
    () => ({ action: "move_forward", distance: this.number(0, 100) }),
    () => ({ action: "move_backward", distance: this.number(0, 100) }),
    () => ({ action: "turn", angle: this.number(-3600, 3600) }),
    () => ({ action: "stop" }),
    () => ({ action: "drive", linear: this.number(-9, 9), angular: this.number(-900, 900) }),
    () => ({ action: "arc", radius: this.number(-100, 100), angle: this.number(-3600, 3600) }),
    () => ({ action: "set_speed", linear: this.number(0.001, 9) }),
    () => ({ action: "set_speed", angular: this.number(0.001, 900) }),
    () => ({
      action: "set_speed",
      linear: this.number(0.001, 9),
      angular: this.number(0.001, 900),
    }),
    () => ({
      action: "go_to",
      x: this.number(-100, 100),
      y: this.number(-100, 100),
      avoid: this.pick([true, false]),
    }),
    () => ({
      action: "go_to_place",
      place: this.text(2),
      avoid: this.pick([true, false]),
    }),
    () => ({ action: "wait", seconds: this.number(0, 600) }),
    () => ({ action: "wait_until", condition: this.boolean(2) }),
    () => ({
      action: "wait_until",
      condition: this.boolean(2),
      timeout: this.number(0.0001, 600),
    }),
    () => ({
      action: "pen",
      down: this.pick([true, false]),
      ...this.maybe({ color: this.pick(COLOURS) }),
    }),
    () => ({ action: "ask", question: this.text(2), variable: this.name() }),
    () => ({ action: "mark", symbol: this.pick(["X", "O"]) }),
    () => ({ action: "mark", symbol: { var: this.name() } }),
    () => ({ action: "say", text: this.any(3) }),
    () => ({ action: "beep" }),
    () => ({ action: "classify_gestures", timeout: this.number(0.0001, 600) }),
    () => ({ action: "read_number", timeout: this.number(0.0001, 600) }),
    () => ({ action: "set_gesture_result", result: this.text(2) }),
    () => ({ action: "set_variable", name: this.name(), value: this.any(3) }),
    () => ({ action: "change_variable", name: this.name(), by: this.number(-9, 9) }),
    () => ({ action: "append", list: this.name(), value: this.any(2) }),
    () => ({
      action: "replace_item",
      list: this.name(),
      position: this.number(1, 1),
      value: this.any(2),
    }),
    () => this.ending(),
    () => this.ending(),
    () => this.ending(),
    () => this.call() ?? { action: "stop" },
  ];

  private nested(depth: number): (() => Command)[] {
    const commands = () => this.commands(depth);
    const branch = (): Branch => ({ condition: this.boolean(2), commands: commands() });
    const loop = () => this.body(depth);
    return [
      () => ({ action: "repeat", times: this.count(), commands: loop() }),
      () => ({ action: "while", condition: this.boolean(2), commands: loop() }),
      () => ({ action: "until", condition: this.boolean(2), commands: loop() }),
      () => ({
        action: "for",
        variable: this.name(),
        from: this.number(-9, 9),
        to: this.number(-9, 9),
        by: this.number(0.1, 9),
        commands: loop(),
      }),
      () => ({ action: "forever", commands: loop() }),
      () => ({
        action: "conditional_execution",
        ...branch(),
        ...this.maybe({ elif: [branch(), branch()].slice(this.whole(2)) }),
        ...this.maybe({ else: [this.command(depth), ...commands()] }),
      }),
    ];
  }

  private call(): Command | null {
    const expression = this.callExpression(1);
    return (
      expression && { action: "call", function: expression.call, arguments: expression.arguments }
    );
  }

  private callExpression(depth: number) {
    const definition = this.functions[this.whole(this.functions.length)];
    if (!definition) return null;
    const values = definition.parameters.map((name) => [name, this.any(depth - 1)] as const);
    return { call: definition.name, arguments: Object.fromEntries(values) };
  }

  private number(low: number, high: number): Expression {
    const literal = () =>
      Number((low + this.random() * (high - low)).toPrecision(this.pick([1, 3, 15])));
    const within = () => Math.min(Math.max(literal(), low), high);
    return this.whole(3) > 0 ? within() || 0 : this.computed(2);
  }

  private computed(depth: number): Expression {
    const inner = () => this.numeric(depth - 1);
    return this.pick<() => Expression>([
      () => ({ op: this.pick(["+", "-", "*", "/", "%", "**"]), args: [inner(), inner()] }),
      () => ({ op: "-", args: [0, inner()] }),
      () => ({ op: this.pick(["abs", "round", "sqrt", "sin", "cos", "tan"]), args: [inner()] }),
      () => ({ op: this.pick(["min", "max"]), args: this.several(1, inner) }),
      () => ({ op: "random_int", args: [inner(), inner()] }),
      () => ({ op: "length", args: [this.whole(2) ? this.text(depth - 1) : this.list()] }),
      () => ({ op: "position_of", args: [this.list(), this.any(depth - 1)] }),
      () => this.reading("Number"),
      () => this.reading("Number"),
      () => this.reading("Number"),
      ...this.wild(depth),
    ])();
  }

  /** A reading of a random sensor whose value has the type. */
  private reading(type: "Number" | "Boolean" | "String"): Expression {
    const row = this.pick(SENSOR_ROWS.filter(({ gives }) => gives === type));
    const sensor = this.pick<string>(row.sensors);
    if (!row.asked) return { sensor };
    const { key } = row.asked;
    if ("choices" in row.asked) return { sensor, [key]: this.pick<string>(row.asked.choices) };
    const { min, max } = row.asked.limits;
    const asked = this.whole(2) ? min + this.whole(max - min + 1) : { var: this.name() };
    return { sensor, [key]: asked };
  }

  private numeric(depth: number): Expression {
    if (depth <= 0) return this.pick([0, 1, -2.5, 1e-7, 1e21, 123456789.125]);
    return this.computed(depth);
  }

  private boolean(depth: number): Expression {
    const inner = () => this.boolean(depth - 1);
    if (depth <= 0) return this.pick([true, false]);
    return this.pick<() => Expression>([
      () => ({ op: this.pick(["and", "or"]), args: this.several(2, inner) }),
      () => ({ op: "not", args: [inner()] }),
      () => ({ op: this.pick(["==", "!="]), args: [this.any(depth - 1), this.any(depth - 1)] }),
      () => ({ op: "==", args: [{ sensor: "floor" }, this.pick(["red", "magenta", ""])] }),
      () => ({ op: "!=", args: ["B", { gesture: "result" }] }),
      () => ({
        op: this.pick(["<", "<=", ">", ">="]),
        args: [this.numeric(depth - 1), this.numeric(depth - 1)],
      }),
      () => ({ op: "contains", args: [{ var: this.name() }, this.any(depth - 1)] }),
      () => this.reading("Boolean"),
      ...this.wild(depth),
    ])();
  }

  private text(depth: number): Expression {
    if (depth <= 0) return this.pick(["", "B", " dois  espaços ", "ção “ü” 机器人\n2", "red"]);
    return this.pick<() => Expression>([
      () => this.text(0),
      () => ({ op: "join", args: this.several(1, () => this.any(depth - 1)) }),
      () => ({ gesture: "result" }),
      () => this.reading("String"),
      ...this.wild(depth),
    ])();
  }

  private list(): Literal[] {
    const literal = () => this.pick<Literal>([0, -1.5, "azul", "", true, false]);
    return Array.from({ length: this.pick([0, 1, 3, 7, 40]) }, literal);
  }

  /** Generators of expressions whose type is known only at run time. */
  private wild(depth: number): (() => Expression)[] {
    return [
      () => ({ var: this.name() }),
      () => ({
        op: "item",
        args: [this.whole(2) ? this.list() : { var: this.name() }, this.numeric(depth - 1)],
      }),
      () => this.callExpression(depth) ?? { var: this.name() },
    ];
  }

  private any(depth: number): Expression {
    return this.pick<() => Expression>([
      () => this.numeric(depth),
      () => this.boolean(depth),
      () => this.text(depth),
      () => this.list(),
    ])();
  }

  private count(): Expression {
    return this.pick([0, 4, 100_000, { var: this.name() }]);
  }

  private name(): string {
    return this.pick(["lado", "ângulo é", "x", "X", "_1", "número de voltas", "变量"]);
  }

  private id(): string {
    return `b${this.ids++}`;
  }

  private several(min: number, make: () => Expression): Expression[] {
    return Array.from({ length: min + this.whole(3) }, make);
  }

  private maybe<T extends object>(part: T): Partial<T> {
    return this.whole(3) === 0 ? part : {};
  }

  private pick<T>(from: readonly T[]): T {
    return from[this.whole(from.length)] as T;
  }

  private whole(below: number): number {
    return Math.floor(this.random() * below);
  }

  /** A random number in [0, 1), by Mulberry32. */
  private random(): number {
    this.state = (this.state + 0x6d2b79f5) >>> 0;
    let t = this.state;
    t = Math.imul(t ^ (t >>> 15), t | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  }
}

const COLOURS = ["black", "red", "orange", "yellow", "green", "blue", "purple", "white"];
