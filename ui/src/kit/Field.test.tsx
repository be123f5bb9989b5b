import { cleanup, fireEvent, render } from "@testing-library/preact";
import { afterEach, describe, expect, test, vi } from "vitest";
import { Field, FileButton, PinField } from "./Field";
import { reportTo } from "./report";
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

test("a button for files hands over the file that is chosen, and reports what fails", async () => {
  const report = vi.fn();
  reportTo(report);
  const lost = new Error("lost");
  const onFile = vi.fn(() => Promise.reject(lost));
  const { container, getByRole, getByTestId } = render(
    <FileButton accept=".pinel" testId="file" onFile={onFile}>
      Trazer
    </FileButton>,
  );
  const input = getByTestId("file") as HTMLInputElement;
  const click = vi.spyOn(input, "click");
  fireEvent.click(getByRole("button", { name: "Trazer" }));
  expect(click).toHaveBeenCalledOnce();
  const file = new File(["{}"], "a.pinel");
  fireEvent.change(input, { target: { files: [file] } });
  expect(onFile).toHaveBeenCalledWith(file);
  await vi.waitFor(() => expect(report).toHaveBeenCalledWith(lost));
  await passesAxe(container);
});
