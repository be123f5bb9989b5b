import { act, cleanup, render } from "@testing-library/preact";
import { render as draw } from "preact";
import { afterEach, expect, test } from "vitest";
import { lazy } from "./lazy";

afterEach(cleanup);

test("a part that another element fetched meanwhile is drawn", async () => {
  let finish = () => {};
  const fetched = new Promise<void>((resolve) => {
    finish = resolve;
  });
  const Part = lazy(async () => {
    await fetched;
    return () => <p>part</p>;
  });
  const first = render(<Part key="first" />);
  // its effects run after the part has arrived
  const { requestAnimationFrame } = globalThis;
  const effects: FrameRequestCallback[] = [];
  globalThis.requestAnimationFrame = (effect) => effects.push(effect);
  const container = document.createElement("div");
  document.body.append(container);
  draw(<Part key="second" />, container);
  finish();
  await act(async () => {
    await fetched;
    await new Promise((resolve) => setTimeout(resolve));
  });
  globalThis.requestAnimationFrame = requestAnimationFrame;
  await act(async () => {
    for (const effect of effects) effect(0);
    await new Promise((resolve) => setTimeout(resolve));
  });
  expect(first.container.textContent).toBe("part");
  expect(container.textContent).toBe("part");
  draw(null, container);
  container.remove();
});
