import { fireEvent, render, waitFor } from "@testing-library/preact";
import { Check } from "lucide-preact";
import { describe, expect, test, vi } from "vitest";
import { Button } from "./Button";
import { reportTo } from "./report";
import { behavesAsControl, passesAxe } from "./testing/control";

const button = () => document.querySelector("button") as HTMLButtonElement;

/** A promise that the test settles. */
function pending() {
  let end: { resolve(): void; reject(error: unknown): void } | null = null;
  const promise = new Promise<void>((resolve, reject) => {
    end = { resolve, reject };
  });
  return { promise, ...(end as unknown as { resolve(): void; reject(error: unknown): void }) };
}

describe("a button", () => {
  behavesAsControl(({ elementRef, ...props }) => (
    <Button
      {...props}
      elementRef={elementRef as { current: HTMLButtonElement | null }}
      icon={Check}
    >
      Salvar
    </Button>
  ));

  test("with an icon alone has its name, and shows it as a tip", async () => {
    const { container } = render(<Button icon={Check} label="Salvar" />);
    expect(button().className).toBe("button button--icon");
    expect([button().ariaLabel, button().title]).toEqual(["Salvar", "Salvar"]);
    await passesAxe(container);
  });

  test("with words shows only the tip that it was given", () => {
    render(<Button label="Renomear: Robôs">Renomear</Button>);
    expect(button().title).toBe("");
  });

  test.each([
    ["main", "button button--run"],
    ["stop", "button button--stop"],
    ["plain", "button button--plain"],
    ["bare", "figure"],
  ] as const)("of kind %s looks so", (kind, expectedClass) => {
    render(
      <Button kind={kind} class={kind === "bare" ? "figure" : undefined}>
        3
      </Button>,
    );
    expect(button().className).toBe(expectedClass);
  });

  test("tells what is on, open and shown", () => {
    render(
      <Button pressed open={false} current="step">
        3
      </Button>,
    );
    const { ariaPressed, ariaExpanded } = button();
    expect([ariaPressed, ariaExpanded]).toEqual(["true", "false"]);
    expect(button().getAttribute("aria-current")).toBe("step");
    expect(button().hasAttribute("aria-busy")).toBe(false);
  });

  test("is busy while what it began goes on, and does it once", async () => {
    const { promise, resolve } = pending();
    const onPress = vi.fn(() => promise);
    render(<Button onPress={onPress}>Salvar</Button>);
    fireEvent.click(button());
    fireEvent.click(button());
    await waitFor(() => expect(button().ariaBusy).toBe("true"));
    fireEvent.click(button());
    expect(onPress).toHaveBeenCalledTimes(1);
    resolve();
    await waitFor(() => expect(button().ariaBusy).toBeNull());
    fireEvent.click(button());
    expect(onPress).toHaveBeenCalledTimes(2);
  });

  test("reports what failed, and can be pressed again", async () => {
    const shown = vi.fn();
    reportTo(shown);
    render(<Button onPress={() => Promise.reject(new Error("full"))}>Salvar</Button>);
    fireEvent.click(button());
    await waitFor(() => expect(shown).toHaveBeenCalledWith(new Error("full")));
    await waitFor(() => expect(button().ariaBusy).toBeNull());
  });

  test("that is busy sends no form, by press or by Enter", () => {
    const onSubmit = vi.fn((event: Event) => event.preventDefault());
    const form = (busy: boolean) => (
      <form onSubmit={onSubmit}>
        <Button submit busy={busy}>
          Salvar
        </Button>
      </form>
    );
    const { rerender } = render(form(true));
    fireEvent.click(button());
    expect(onSubmit).not.toHaveBeenCalled();
    rerender(form(false));
    fireEvent.click(button());
    expect(onSubmit).toHaveBeenCalledTimes(1);
  });

  test("does nothing while it is disabled", () => {
    const onPress = vi.fn();
    render(
      <Button disabled onPress={onPress}>
        Salvar
      </Button>,
    );
    button().click();
    expect(onPress).not.toHaveBeenCalled();
  });
});
