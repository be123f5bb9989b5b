import { beforeEach, describe, expect, test, vi } from "vitest";
import { ApiError } from "../../api/errors";
import type { Fault, OnDisk, World } from "../../api/model";
import { OwnWorld } from "./own_world";

const SOUND = { name: "sound" } as World;
const FAULTY = { name: "faulty" } as World;

/** A server that takes no world called faulty, and remembers which ones it was sent. */
function server() {
  const sent: (World | null)[] = [];
  const save = async (world: World | null): Promise<OnDisk> => {
    sent.push(world);
    if (world?.name === "faulty") throw new ApiError(422, { code: "invalid_world" });
    return { id: `v${sent.length}`, faults: [] };
  };
  return { sent, save };
}

/** A check that comes too late to say anything. */
const nothing = async () => [];

beforeEach(() => sessionStorage.clear());

describe("a world with faults", () => {
  test("does not keep the blocks from being saved, with the last world that was taken", async () => {
    const { sent, save } = server();
    const own = new OwnWorld("p", null, nothing);
    own.now.value = SOUND;
    await own.saveWith(SOUND, save);
    own.now.value = FAULTY;
    await own.saveWith(FAULTY, save);
    expect(sent).toEqual([SOUND, FAULTY, SOUND]);
    expect(own.isRefused.value).toBe(true);
  });

  test("is not sent again, nor at all where its faults are known", async () => {
    const { sent, save } = server();
    const own = new OwnWorld("p", SOUND, nothing);
    own.now.value = FAULTY;
    own.refuse(FAULTY);
    await own.saveWith(FAULTY, save);
    expect(sent).toEqual([SOUND]);
  });

  test("is not sent where the check finds them, but by the last save, which cannot wait", async () => {
    const { sent, save } = server();
    const fault = { pointer: "", message: "", remedy: "" } as Fault;
    const check = vi.fn(async (world: World) => (world === FAULTY ? [fault] : []));
    const own = new OwnWorld("p", SOUND, check);
    own.now.value = FAULTY;
    await own.saveWith(FAULTY, save);
    await own.saveWith(FAULTY, save);
    await own.saveWith(SOUND, save);
    expect(sent).toEqual([SOUND, SOUND, SOUND]);
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
    const own = new OwnWorld("p", SOUND, nothing);
    own.now.value = FAULTY;
    own.refuse(FAULTY);
    own.close();
    const later = new OwnWorld("p", SOUND, nothing);
    expect(later.now.value).toEqual(FAULTY);
    expect(later.isRefused.value).toBe(true);
    const mended = { name: "mended" } as World;
    later.now.value = mended;
    expect(later.isRefused.value).toBe(false);
    await later.saveWith(mended, save);
    expect(sent).toEqual([mended]);
    expect(new OwnWorld("p", mended, nothing).now.value).toBe(mended);
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
  await expect(own.saveWith(SOUND, save)).rejects.toThrow();
  expect(own.isRefused.value).toBe(false);
});
