import { cleanup, fireEvent, render } from "@testing-library/preact";
import { afterEach, describe, expect, test, vi } from "vitest";
import { Field, PinField } from "./Field";
import { passesAxe } from "./testing/control";

afterEach(cleanup);

describe("a field", () => {
  test("is named by its label, and told about by its hint", async () => {
    const { container, getByLabelText } = render(
      <Field label="Escola" hint="Como na porta" value="" onText={() => {}} lang="es" />,
    );
    const input = getByLabelText("Escola");
    expect(input.lang).toBe("es");
    const hint = document.getElementById(input.getAttribute("aria-describedby") ?? "");
    expect(hint?.textContent).toBe("Como na porta");
    await passesAxe(container);
  });

  test("tells what is typed", () => {
    const onText = vi.fn();
    const { getByLabelText } = render(<PinField label="Senha" value="" onText={onText} />);
    fireEvent.input(getByLabelText("Senha"), { target: { value: "12" } });
    expect(onText).toHaveBeenCalledWith("12");
  });
});
