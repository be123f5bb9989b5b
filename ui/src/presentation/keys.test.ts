import { expect, test } from "vitest";
import { actionOf } from "./keys";

function actionAt(target: Element, key: string, more: KeyboardEventInit = {}) {
  document.body.append(target);
  let action: ReturnType<typeof actionOf> | undefined;
  target.addEventListener("keydown", (event) => {
    action = actionOf(event as KeyboardEvent);
  });
  target.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, ...more }));
  target.remove();
  return action;
}

const element = (name: string, testId = "") => {
  const made = document.createElement(name);
  made.dataset.testid = testId;
  return made;
};

test.each([
  ["PageDown", "next"],
  ["PageUp", "previous"],
  ["ArrowRight", "next"],
  [" ", "next"],
  ["F5", "play"],
  ["b", "black"],
  ["B", "black"],
  [".", "black"],
  ["Escape", "leave"],
])("the key %j of a keyboard or a remote does %s", (key, action) => {
  expect(actionAt(element("main"), key)).toBe(action);
});

test("space and Enter press the button that has the focus", () => {
  expect(actionAt(element("button"), " ")).toBeNull();
  expect(actionAt(element("button"), "Enter")).toBeNull();
  expect(actionAt(element("button"), "PageDown")).toBe("next");
});

test("arrow keys turn the floor in 3D, and keys of a remote step there too", () => {
  expect(actionAt(element("canvas", "scene-3d"), "ArrowRight")).toBeNull();
  expect(actionAt(element("canvas", "scene-3d"), "PageDown")).toBe("next");
});

test("shortcuts of the system stay its own", () => {
  expect(actionAt(element("main"), "p", { ctrlKey: true })).toBeNull();
});
