import { describe, expect, test } from "vitest";
import editorFile from "../../../pinel_desktop/messages/catalogue/pt-BR/page/editor.json";
import type { Language } from "../api/model";
import { textsOf } from ".";
import { decimal, duration, headingDegrees, relativeDateAndTime, relativeTime } from "./format";
import { LANGUAGES } from "./languages";

import { reasonText } from "./reasons";
import type { Texts } from "./texts";

type Leaf = string | ((values: object) => string);

/** Every text of a catalogue by its path; placeholders are filled with 1 and with 2. */
function leaves(node: object, path = ""): [string, string][] {
  return Object.entries(node).flatMap(([key, value]: [string, Leaf | object]) => {
    const here = `${path}/${key}`;
    if (typeof value === "string") return [[here, value]] as [string, string][];
    if (typeof value === "object") return leaves(value, here);
    return [1, 2].map((n) => {
      const text = value(new Proxy({}, { get: () => n }));
      return [`${here}(${n})`, text] as [string, string];
    });
  });
}

/** The texts that are the page's own: no words of the server, none of Blockly, none that pupils bring to the search. */
function own(language: Language): Partial<Texts> {
  const { blockly, reasons, figures, cameraProblems, searchTerms, ...texts } = textsOf(language);
  return texts;
}

/** The page's texts in which a language has to differ from the others. */
function all(language: Language): Partial<Texts> {
  const { blocks, ...texts } = own(language);
  return texts;
}

/** Our own words for what Blockly says. */
function editorMessages(language: Language): object {
  return Object.fromEntries(
    Object.keys(editorFile.editor).map((key) => [key, textsOf(language).blockly[key]]),
  );
}

/** What pupils read: no part of the teacher's. */
function toPupils(language: Language): object {
  const { teacher, exchange, making, review, calibration, overhead, ...texts } = own(language);
  return { ...texts, editor: editorMessages(language) };
}

/** How one would speak to a single pupil: pupils are a group. The teacher's texts are not looked at. */
const TO_ONE: Partial<Record<Language, RegExp>> = {
  "pt-BR":
    /\b(Escreva|Escolha|Aperte|Arraste|Use|Clique|Conserte|Monte|Compare|Troque|Mude|Feche|Abra|você)(?!\p{L})/u,
  es: /\b(Escribe|Elige|Presiona|Arrastra|Usa|Haz|Arma|Arregla|Cierra|Abre|tú|tu|tus)(?!\p{L})/u,
};

describe.each(LANGUAGES)("the catalogue %s", (language) => {
  const texts = leaves(all(language));

  test("has no empty text and no forgotten gap", () => {
    for (const [path, text] of texts) {
      expect(text.trim(), path).not.toBe("");
      expect(text, path).not.toMatch(/undefined|NaN|\[object|TODO/);
    }
  });

  test("does not repeat another language's long texts", () => {
    const others = LANGUAGES.filter((other) => other !== language).flatMap((other) =>
      leaves(all(other)).map(([path, text]) => `${path} ${text}`),
    );
    for (const [path, text] of texts) {
      if (text.length > 24) expect(others).not.toContain(`${path} ${text}`);
    }
  });

  test("speaks to pupils as a group", () => {
    const one = TO_ONE[language] ?? /^(?!)/;
    for (const [path, text] of leaves(toPupils(language))) {
      expect(text, path).not.toMatch(one);
    }
  });

  test("has the server's words for the end of a run", () => {
    const words = reasonText("blocked", { done: 0.5, amount: 1, unit: "m" }, language);
    expect(words?.message).toContain((0.5).toLocaleString(language));
    expect(words?.message).not.toContain("{");
    expect(reasonText("no_such_code", {}, language)).toBeNull();
    const turn = { done: -77.25, amount: -180, unit: "°" };
    const turned = reasonText("blocked", turn, language)?.message;
    expect(turned).toContain(`${(77.25).toLocaleString(language)} ° `);
    expect(turned).not.toMatch(/[-\u2212]\d/);
  });
});

test("a message of the server has the form of its count", () => {
  const said = (count: number) => reasonText("odometry_invalid", { count }, "en")?.message;
  expect(said(1)).toBe("The robot reports impossible positions (1 message).");
  expect(said(2)).toBe("The robot reports impossible positions (2 messages).");
});

describe("figures", () => {
  test("are written as the language writes them", () => {
    expect(decimal(0.62, 2, "pt-BR")).toBe("0,62");
    expect(decimal(0.62, 2, "en")).toBe("0.62");
    expect(decimal(-1, 1, "es")).toBe("\u22121,0");
    expect(decimal(-0.001, 2, "en")).toBe("0.00");
  });

  test("of headings lie above -180 and up to 180 degrees", () => {
    expect(headingDegrees(Math.PI)).toBeCloseTo(180);
    expect(headingDegrees(-Math.PI + 0.001)).toBe(180);
    expect(headingDegrees((3 * Math.PI) / 2)).toBeCloseTo(-90);
    expect(headingDegrees(-0.0001)).toBe(0);
  });

  test("of durations change to minutes", () => {
    expect(duration(17.2, "pt-BR")).toBe("17,2\u00a0s");
    expect(duration(125, "pt-BR")).toBe("2\u00a0min\u00a005\u00a0s");
  });

  test("of moments are said as on that day", () => {
    const texts = textsOf("pt-BR");
    const now = new Date(2026, 10, 21, 15, 0, 0);
    const ago = (minutes: number) =>
      relativeTime(new Date(now.getTime() - minutes * 60_000).toISOString(), now, "pt-BR", texts);
    expect(ago(0)).toBe("agora");
    expect(ago(5)).toBe("há 5 min");
    expect(ago(120)).toMatch(/^hoje, /);
    expect(ago(60 * 20)).toMatch(/^ontem, /);
    expect(ago(60 * 24 * 9)).toBe("12\u00a0de\u00a0nov., 15:00");
    expect(ago(60 * 24 * 365)).toContain("de\u00a02025, 15:00");
  });

  test("of runs tell the time of day, however short ago they were", () => {
    const now = new Date(2026, 10, 21, 15, 0, 0);
    const at = new Date(2026, 10, 21, 14, 58, 0).toISOString();
    expect(relativeDateAndTime(at, now, "pt-BR", textsOf("pt-BR"))).toBe("hoje, 14:58");
    expect(relativeDateAndTime(at, now, "en", textsOf("en"))).toMatch(/^today, 2:58\sPM$/);
  });
});

test.each([...LANGUAGES])("a run that a power cut ended has words for it in %s", (language) => {
  for (const code of ["interrupted", "engine_lost"]) {
    expect(reasonText(code, {}, language)?.remedy).toBeTruthy();
  }
});
