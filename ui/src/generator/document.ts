/** The program document (version 1): metres, seconds, degrees, counterclockwise positive. */
export interface ProgramDocument {
  pinel_ir: 1;
  name: string;
  functions: [];
  commands: Command[];
}

/** One command; `block` is the id of the block it came from. */
export interface Command {
  action: string;
  block?: string;
  [parameter: string]: unknown;
}

export type Expression =
  | number
  | string
  | boolean
  | { gesture: "result" }
  | { op: string; args: Expression[] };
