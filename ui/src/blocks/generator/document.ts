/** The program document (version 1): metres, seconds, degrees, counterclockwise positive. */
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

/** One command; `block` is the id of the block it came from. */
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
  | { gesture: "result" }
  | { var: string }
  | { op: string; args: Expression[] }
  | { sensor: string } // with its argument, see sensor_rows.ts
  | { call: string; arguments: Record<string, Expression> };

/** A part of a conditional. */
export interface Branch {
  condition?: Expression;
  commands: Command[];
}
