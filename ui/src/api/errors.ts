import type { ErrorBody, Fault } from "./model";

/** The server answered with an error, whose texts can be shown to people. */
export class ApiError extends Error {
  readonly code: string;
  readonly remedy: string;
  readonly details: string;
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
    this.details = body.details ?? "";
    this.faults = body.faults ?? [];
    this.params = body.params ?? {};
  }
}

/** No response came: the app behind the page has exited. */
export class ServerUnreachable extends Error {
  override readonly name = "ServerUnreachable";
}
