import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { changed, hand, sightOf } from "./testing/camera_events";

const cameraApi = { status: vi.fn(), warmUp: vi.fn() };
vi.mock("../api/camera", () => ({ cameraApi }));

const MINUTE_MS = 60_000;
let page: typeof import("./sight");

beforeEach(async () => {
  vi.resetModules();
  vi.clearAllMocks();
  cameraApi.warmUp.mockResolvedValue({});
  page = await import("./sight");
});

describe("what the camera sees", () => {
  test("is the newest, until the camera goes off", () => {
    page.receive(changed("opening"));
    page.receive(changed("on"));
    page.receive(sightOf(hand()));
    expect(page.sight.value?.hands).toHaveLength(1);
    page.receive(changed("off"));
    expect(page.sight.value).toBeNull();
    page.receive(sightOf(hand())); // was sent before the camera switched off
    expect(page.sight.value).toBeNull();
  });

  test("keeps its proportions while there is none", () => {
    page.receive(changed("on"));
    page.receive({ ...sightOf(), aspect: 16 / 9 });
    page.receive(changed("off"));
    expect(page.aspect.value).toBeCloseTo(16 / 9);
  });
});

test("a slow response about the camera does not undo an event that came meanwhile", async () => {
  let respond: (status: object) => void = () => {};
  cameraApi.status.mockReturnValue(
    new Promise((resolve) => {
      respond = resolve;
    }),
  );
  const asked = page.refresh();
  page.receive(changed("on"));
  respond({ state: "opening", source: "0", problem: null });
  await asked;
  expect(page.camera.value.mode).toBe("on");
});

describe("why the camera is of no use", () => {
  test("stays while it is tried again, so that nothing flickers, until it works", () => {
    page.receive(changed("failed", "camera_missing"));
    expect(page.hasPicture.value).toBe(false);
    page.receive(changed("off"));
    page.receive(changed("opening"));
    expect(page.camera.value).toMatchObject({
      mode: "opening",
      problem: { message: "Não há câmera." },
    });
    expect(page.hasPicture.value).toBe(false);
    page.receive(changed("on"));
    expect(page.camera.value.problem).toBeNull();
    expect(page.hasPicture.value).toBe(true);
  });

  test("leaves the picture in sight where one sees in it what is wrong", () => {
    page.receive(changed("on"));
    page.receive(sightOf(hand()));
    page.receive(changed("failed", "camera_dark"));
    expect(page.hasPicture.value).toBe(true);
    expect(page.sight.value).not.toBeNull();
  });

  test("is asked for when the stream begins again and the camera was in use", async () => {
    cameraApi.status.mockResolvedValue({
      state: "failed",
      source: "0",
      problem: { code: "camera_busy", message: "Ocupada.", remedy: "Fechem o outro." },
    });
    await page.resync();
    expect(cameraApi.status).not.toHaveBeenCalled();
    page.receive(changed("on"));
    await page.resync();
    expect(page.camera.value.problem?.message).toBe("Ocupada.");
  });
});

describe("a program that captures", () => {
  beforeEach(() => void vi.useFakeTimers());
  afterEach(() => void vi.useRealTimers());

  test("starts the camera process at once, and keeps it running while it is open", () => {
    const end = page.warmUpRegularly();
    expect(cameraApi.warmUp).toHaveBeenCalledTimes(1);
    vi.advanceTimersByTime(5 * MINUTE_MS);
    expect(cameraApi.warmUp).toHaveBeenCalledTimes(6);
    end();
    vi.advanceTimersByTime(5 * MINUTE_MS);
    expect(cameraApi.warmUp).toHaveBeenCalledTimes(6);
  });

  test("asks again after a minute where the app did not answer", () => {
    cameraApi.warmUp.mockRejectedValueOnce(new Error("gone"));
    const end = page.warmUpRegularly();
    vi.advanceTimersByTime(MINUTE_MS);
    expect(cameraApi.warmUp).toHaveBeenCalledTimes(2);
    end();
  });
});
