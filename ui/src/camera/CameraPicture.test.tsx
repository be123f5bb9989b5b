import { act, cleanup, render } from "@testing-library/preact";
import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { passesAxe } from "../kit/testing/control";
import { changed, hand, sightOf } from "./testing/camera_events";

const cameraApi = { status: vi.fn() };
vi.mock("../api/camera", () => ({
  cameraApi,
  previewAddress: (attempt: number) => `/preview/${attempt}`,
}));

const { CameraPicture } = await import("./CameraPicture");
const { receive } = await import("./sight");

beforeEach(() => {
  vi.useFakeTimers();
  cameraApi.status.mockReturnValue(new Promise(() => {}));
});

afterEach(() => {
  cleanup();
  receive(changed("on"));
  receive(changed("off"));
  vi.useRealTimers();
});

function draw() {
  const { container, getByTestId, queryByTestId } = render(<CameraPicture />);
  return {
    container,
    state: () => getByTestId("camera-picture").dataset.state,
    trouble: () => queryByTestId("camera-trouble")?.textContent,
    source: () => container.querySelector("img")?.getAttribute("src"),
    isHidden: () => container.querySelector<HTMLElement>(".camera__view")?.hidden,
  };
}

describe("the picture of the camera", () => {
  test("is asked for at once, which switches the camera on, and is shown when it is there", async () => {
    const page = draw();
    expect(page.source()).toBe("/preview/0");
    expect([page.state(), page.isHidden()]).toEqual(["off", true]);
    expect(page.container.textContent).toBe("Abrindo a câmera…");
    act(() => receive(changed("opening")));
    act(() => receive(changed("on")));
    expect([page.state(), page.isHidden()]).toEqual(["on", false]);
    expect(page.container.textContent).toBe("");
    vi.useRealTimers();
    await passesAxe(page.container);
  });

  test("has a hand drawn over it, with all its bones", () => {
    const page = draw();
    act(() => receive(changed("on")));
    act(() => receive(sightOf(hand(), hand({ sure: false }))));
    const hands = [...page.container.querySelectorAll<SVGElement>(".skeleton__hand")];
    expect(hands.map((one) => one.dataset.sure)).toEqual(["true", "false"]);
    const bones = hands[0]?.querySelector("path")?.getAttribute("d") ?? "";
    expect(bones.match(/M/g)).toHaveLength(6);
    expect(bones).not.toContain("undefined");
    act(() => receive(sightOf()));
    expect(page.container.querySelector(".skeleton__hand")).toBeNull();
  });

  test("gives way to what is wrong with the camera, and is asked for again until it is there", () => {
    const page = draw();
    act(() => receive(changed("failed", "camera_missing")));
    expect(page.state()).toBe("failed");
    expect(page.trouble()).toBe(
      "A câmera 1 não foi encontrada. Liguem o cabo da câmera, ou escolham outra.",
    );
    act(() => void vi.advanceTimersByTime(9000));
    expect(page.source()).toBe("/preview/2");
    act(() => receive(changed("on")));
    act(() => void vi.advanceTimersByTime(9000));
    expect(page.source()).toBe("/preview/2");
    expect([page.state(), page.trouble()]).toEqual(["on", undefined]);
  });

  test("stays in sight where one sees in it what is wrong", () => {
    const page = draw();
    act(() => receive(changed("failed", "camera_dark")));
    expect([page.state(), page.isHidden(), page.trouble()]).toEqual(["on", false, undefined]);
  });

  test("stops loading when it leaves the page", () => {
    const page = draw();
    const picture = page.container.querySelector("img");
    cleanup();
    expect(picture?.hasAttribute("src")).toBe(false);
  });
});
