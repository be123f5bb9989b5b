import { beforeEach, describe, expect, test, vi } from "vitest";
import { ApiError } from "../../api/errors";
import type { Fault, SavedState, World } from "../../api/model";
import { OwnWorld } from "./own_world";

const VALID = { name: "sound" } as World;
const FAULTY = { name: "faulty" } as World;

/** A fake server that rejects worlds named "faulty" and records the worlds that it receives. */
function server() {
  const sent: (World | null)[] = [];
  const save = async (world: World | null): Promise<SavedState> => {
    sent.push(world);
    if (world?.name === "faulty") throw new ApiError(422, { code: "invalid_world" });
    return { id: `v${sent.length}`, faults: [] };
  };
  return { sent, save };
}

/** A check that finds no fault, so that the save itself must find it. */
const nothing = async () => [];

beforeEach(() => sessionStorage.clear());

describe("a world with faults", () => {
  test("does not keep the blocks from being saved, with the last world that was taken", async () => {
    const { sent, save } = server();
    const own = new OwnWorld("p", null, nothing);
    own.now.value = VALID;
    await own.saveWith(VALID, save);
    own.now.value = FAULTY;
    await own.saveWith(FAULTY, save);
    expect(sent).toEqual([VALID, FAULTY, VALID]);
    expect(own.isRefused.value).toBe(true);
  });

  test("is not sent again, nor at all where its faults are known", async () => {
    const { sent, save } = server();
    const own = new OwnWorld("p", VALID, nothing);
    own.now.value = FAULTY;
    own.refuse(FAULTY);
    await own.saveWith(FAULTY, save);
    expect(sent).toEqual([VALID]);
  });

  test("is not sent where the check finds them, but by the last save, which cannot wait", async () => {
    const { sent, save } = server();
    const fault = { pointer: "", message: "", remedy: "" } as Fault;
    const check = vi.fn(async (world: World) => (world === FAULTY ? [fault] : []));
    const own = new OwnWorld("p", VALID, check);
    own.now.value = FAULTY;
    await own.saveWith(FAULTY, save);
    await own.saveWith(FAULTY, save);
    await own.saveWith(VALID, save);
    expect(sent).toEqual([VALID, VALID, VALID]);
    expect(own.isRefused.value).toBe(true);
    expect(check).toHaveBeenCalledTimes(1);
    await own.saveWith({ ...FAULTY }, save, true);
    expect(sent.map((world) => world?.name)).toEqual([
      "sound",
      "sound",
      "sound",
      "faulty",
      "sound",
    ]);
  });

  test("is there after a reload, and saved once it is mended", async () => {
    const { sent, save } = server();
    const own = new OwnWorld("p", VALID, nothing);
    own.now.value = FAULTY;
    own.refuse(FAULTY);
    own.close();
    const reopened = new OwnWorld("p", VALID, nothing);
    expect(reopened.now.value).toEqual(FAULTY);
    expect(reopened.isRefused.value).toBe(true);
    const repaired = { name: "mended" } as World;
    reopened.now.value = repaired;
    expect(reopened.isRefused.value).toBe(false);
    await reopened.saveWith(repaired, save);
    expect(sent).toEqual([repaired]);
    expect(new OwnWorld("p", repaired, nothing).now.value).toBe(repaired);
  });

  test("is nothing to other programs", () => {
    const own = new OwnWorld("p", null, nothing);
    own.now.value = FAULTY;
    own.refuse(FAULTY);
    expect(new OwnWorld("other", null, nothing).now.value).toBeNull();
  });
});

test("any other trouble is told", async () => {
  const own = new OwnWorld("p", null, nothing);
  const save = () => Promise.reject(new ApiError(413, { code: "body_too_large" }));
  await expect(own.saveWith(VALID, save)).rejects.toThrow();
  expect(own.isRefused.value).toBe(false);
});
