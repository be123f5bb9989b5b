import { beforeEach, describe, expect, test, vi } from "vitest";
import { ApiError } from "../api/errors";
import { asTeacher, door, giveUpWaiting } from "./teacher";

const OPEN = { has_pin: true, is_open: true };
const shut = () => new ApiError(403, { code: "teacher_only" });

beforeEach(() => {
  door.value = OPEN;
});

describe("what only the teacher may do", () => {
  test("is done while the door is open", async () => {
    expect(await asTeacher(async () => 7)).toBe(7);
  });

  test("waits for the PIN when the door has shut, and is done then", async () => {
    const work = vi.fn().mockRejectedValueOnce(shut()).mockResolvedValueOnce("done");
    const done = asTeacher<string>(work);
    await vi.waitFor(() => expect(door.value?.is_open).toBe(false));
    expect(work).toHaveBeenCalledTimes(1);
    door.value = OPEN;
    expect(await done).toBe("done");
  });

  test("is not done later when the teacher has gone elsewhere", async () => {
    const work = vi.fn().mockRejectedValue(shut());
    void asTeacher(work);
    await vi.waitFor(() => expect(door.value?.is_open).toBe(false));
    giveUpWaiting();
    door.value = OPEN;
    await Promise.resolve();
    expect(work).toHaveBeenCalledTimes(1);
  });

  test("says what else went wrong", async () => {
    const taken = new ApiError(409, { code: "group_exists" });
    await expect(asTeacher(() => Promise.reject(taken))).rejects.toBe(taken);
    expect(door.value).toEqual(OPEN);
  });
});
