import type { ErrorBody, Fault } from "./model";

/** The server answered with an error, its words ready for people. */
export class ApiError extends Error {
  readonly code: string;
  readonly remedy: string;
  readonly faults: Fault[];
  readonly params: Record<string, unknown>;

  constructor(
    readonly status: number,
    body: Partial<ErrorBody>,
  ) {
    super(body.message ?? "");
    this.name = "ApiError";
    this.code = body.code ?? `http_${status}`;
    this.remedy = body.remedy ?? "";
    this.faults = body.faults ?? [];
    this.params = body.params ?? {};
  }
}

/** No answer came: the program behind the page has gone. */
export class ServerUnreachable extends Error {
  override readonly name = "ServerUnreachable";
}
