/**
 * The program document (version 1), in metres, seconds and degrees; counterclockwise is positive.
 */
export interface ProgramDocument {
  pinel_ir: 1;
  name: string;
  functions: FunctionDefinition[];
  commands: Command[];
}

export interface FunctionDefinition {
  name: string;
  parameters: string[];
  commands: Command[];
  block?: string;
  comment?: string;
}

/** One command; `block` is the id of its block. */
export interface Command {
  action: string;
  block?: string;
  comment?: string;
  [parameter: string]: unknown;
}

export type Literal = number | string | boolean;

export type Expression =
  | Literal
  | readonly Literal[]
  | { gesture: "result" | "number" }
  | { var: string }
  | { op: string; args: Expression[] }
  | { sensor: string } // with its arguments; sensor_rows.ts lists them
  | { call: string; arguments: Record<string, Expression> };

/** A branch of a conditional. */
export interface Branch {
  condition?: Expression;
  commands: Command[];
}
