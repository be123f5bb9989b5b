import { cleanup, fireEvent, render, screen, within } from "@testing-library/preact";
import { afterEach, beforeEach, describe, expect, test } from "vitest";
import { NAMES } from "../../manual_pages";
import { setLanguage } from "../i18n";
import { passesAxe } from "../kit/testing/control";
import { manualsOrigin } from "../shell/help";
import { route } from "../shell/route";
import { ManualsScreen } from "./ManualsScreen";

beforeEach(() => setLanguage("pt-BR"));
afterEach(cleanup);

const open = async (manual: string | null = null, section: string | null = null) => {
  const drawn = render(<ManualsScreen manual={manual} section={section} />);
  await screen.findByTestId("manuals");
  return drawn;
};
const search = (query: string) =>
  fireEvent.input(screen.getByTestId("manuals-search"), { target: { value: query } });

describe("the list of the manuals", () => {
  test("names each manual and its sections", async () => {
    const { container } = await open();
    const titles = screen.getAllByTestId("manual-link").map((one) => one.textContent);
    expect(titles).toHaveLength(NAMES.length);
    expect(titles[3]).toContain("Instalar nos computadores da escola");
    expect(titles[3]).toContain("Conferir um computador");
    await passesAxe(container);
  });

  test("a search leads to sections", async () => {
    const { container } = await open();
    search("esqueci pin");
    const [first] = screen.getAllByTestId("manual-hit");
    expect(first?.textContent).toContain("Esqueci o PIN");
    expect(first?.getAttribute("href")).toBe("#/manuals/teacher/esqueci-o-pin");
    await passesAxe(container);
    search("xyzzy");
    expect(screen.getByRole("status").textContent).toBe(
      "Nenhum resultado. Tentem outras palavras.",
    );
  });

  test("leads back to the screen from which it was opened", async () => {
    manualsOrigin.value = { screen: "studio", program: "p1" };
    await open();
    const back = screen.getByTestId("manuals-back");
    expect(back.textContent).toBe("Programa");
    expect(back.getAttribute("href")).toBe("#/program/p1");
  });
});

test("the screen from which the manuals are opened is remembered while they are read", () => {
  route.value = { screen: "teacher", part: "robot" };
  route.value = { screen: "manuals", manual: null, section: null };
  route.value = { screen: "manuals", manual: "trust", section: null };
  expect(manualsOrigin.value).toEqual({ screen: "teacher", part: "robot" });
});

describe("a manual", () => {
  test("has its sections beside it", async () => {
    await open("install");
    expect(screen.getByRole("heading", { level: 1 }).textContent).toBe(
      "Instalar nos computadores da escola",
    );
    const sections = screen.getAllByTestId("manual-section").map((one) => one.textContent);
    expect(sections).toContain("Sem instalar");
  });

  test.each(NAMES)("%s passes axe", async (name) => {
    const { container } = await open(name);
    await passesAxe(container);
  });

  test("an address with a section moves the focus to its heading", async () => {
    await open("install", "sem-instalar");
    expect(document.activeElement?.textContent).toBe("Sem instalar");
    fireEvent.click(screen.getAllByTestId("manual-section")[0] as HTMLElement);
    expect(document.activeElement?.tagName).toBe("H2");
    expect(document.activeElement?.textContent).not.toBe("Sem instalar");
  });

  test("shows its pictures from the page itself", async () => {
    const { container } = await open("teacher");
    const pictures = [...container.querySelectorAll("img")];
    expect(pictures.length).toBeGreaterThan(5);
    const foreign = pictures.filter(
      (one) => !one.alt || new URL(one.src).origin !== location.origin,
    );
    expect(foreign).toEqual([]);
  });

  test("one that does not exist shows the list", async () => {
    await open("xyzzy");
    expect(screen.getAllByTestId("manual-link")).toHaveLength(NAMES.length);
  });
});

test("a language without manuals reads them in Portuguese, says so, and can choose English", async () => {
  await setLanguage("es");
  await open("install");
  const line = screen.getByRole("status");
  expect(line.textContent).toContain(
    "Los manuales todavía no existen en este idioma. Este texto: Português.",
  );
  expect(screen.getByRole("article").lang).toBe("pt-BR");
  fireEvent.click(within(line).getByTestId("manuals-language"));
  await screen.findByText("Installing on school PCs");
  expect(screen.getByRole("article").lang).toBe("en");
});
