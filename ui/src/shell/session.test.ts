import { beforeEach, expect, test, vi } from "vitest";
import { api } from "../api/client";
import { ServerUnreachable } from "../api/errors";
import type { Notice, Status } from "../api/model";
import { navigationBlocked } from "./route";
import { connection, notice, refreshStatus, report, showNotice } from "./session";

const named = (code: string): Notice => ({ code, message: code, remedy: "", details: "" });

/** Requests of the status that wait for their response, in the order of the requests. */
let waiting: ((code: string | null) => void)[] = [];

beforeEach(() => {
  waiting = [];
  showNotice(null);
  vi.spyOn(api, "status").mockImplementation(
    () =>
      new Promise((resolve) => {
        waiting.push((code) =>
          resolve({
            engine: "ready",
            language: "pt-BR",
            database: { path: "", writable: true, notice: code === null ? null : named(code) },
          } as unknown as Status),
        );
      }),
  );
});

test("a late response does not bring back the notice that a choice has replaced", async () => {
  const refreshed = refreshStatus();
  showNotice(named("database_begins_empty"));
  waiting[0]?.("database_place_missing");
  await refreshed;
  expect(notice.value?.code).toBe("database_begins_empty");
});

test("a late response from before the server was lost does not open the page's screens again", async () => {
  const before = refreshStatus();
  report(new ServerUnreachable());
  waiting[0]?.(null);
  await before;
  expect([connection.value, navigationBlocked.value]).toEqual(["gone", true]);
  const after = refreshStatus();
  waiting[1]?.(null);
  await after;
  expect([connection.value, navigationBlocked.value]).toEqual(["open", false]);
});

test("of two responses the one to the later request counts, whichever comes first", async () => {
  const first = refreshStatus();
  const second = refreshStatus();
  waiting[1]?.(null);
  await second;
  waiting[0]?.("disk_nearly_full");
  await first;
  expect(notice.value).toBe(null);
  const third = refreshStatus();
  waiting[2]?.("disk_nearly_full");
  await third;
  expect(notice.value?.code).toBe("disk_nearly_full");
});
