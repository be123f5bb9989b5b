import { expect, test } from "vitest";
import { ApiError } from "../api/errors";
import { isSuperseded } from "./Messages";

test("a full disk is told alone: it would be untrue that everything can still be saved", () => {
  const full = new ApiError(507, { code: "disk_full", message: "", remedy: "", params: {} });
  expect(isSuperseded({ code: "disk_nearly_full" }, full)).toBe(true);
  expect(isSuperseded({ code: "database_restored" }, full)).toBe(false);
  expect(isSuperseded({ code: "disk_nearly_full" }, null)).toBe(false);
  expect(isSuperseded({ code: "disk_full" }, full)).toBe(true); // is shown once
});
