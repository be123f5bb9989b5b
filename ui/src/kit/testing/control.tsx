import { cleanup, render } from "@testing-library/preact";
import axe from "axe-core";
import { type ComponentChild, createRef } from "preact";
import { afterEach, expect, test } from "vitest";

export interface ControlProps {
  class?: string;
  testId: string;
  lang?: string;
  elementRef?: { current: HTMLElement | null };
}

/** Switches off axe rules that need landmarks, or a canvas to measure colours. */
const OFF = { region: { enabled: false }, "color-contrast": { enabled: false } };

export async function passesAxe(container: Element): Promise<void> {
  const { violations } = await axe.run(container, { rules: OFF });
  expect(violations.map(({ id, nodes }) => [id, ...nodes.map(({ html }) => html)])).toEqual([]);
}

/** Tests common to all controls of the kit; `draw` renders the control. */
export function behavesAsControl(draw: (props: ControlProps) => ComponentChild): void {
  afterEach(cleanup);

  test("what is not its own goes to the element", () => {
    const { getByTestId } = render(draw({ testId: "it", lang: "es" }));
    expect(getByTestId("it").getAttribute("lang")).toBe("es");
  });

  test("the element can be had by reference", () => {
    const ref = createRef<HTMLElement>();
    const { getByTestId } = render(draw({ testId: "it", elementRef: ref }));
    expect(ref.current).toBe(getByTestId("it"));
  });

  test("a screen's class stands beside the kit's", () => {
    const plain = render(draw({ testId: "plain" })).getByTestId("plain");
    const own = render(draw({ testId: "own", class: "start__more" })).getByTestId("own");
    const classesOf = (element: Element) => element.closest("[class]")?.className.split(" ");
    expect(classesOf(own)).toEqual([...(classesOf(plain) ?? []), "start__more"]);
  });

  test("Tab reaches it", () => {
    const element = render(draw({ testId: "it" })).getByTestId("it");
    element.focus();
    expect(document.activeElement).toBe(element);
    expect(element.tabIndex).toBe(0);
  });

  test("axe finds nothing", async () => {
    await passesAxe(render(draw({ testId: "it" })).container);
  });
}
