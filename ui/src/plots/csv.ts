import type { Language, Texts } from "../i18n";
import { decimalPoint, listSeparator } from "../i18n/format";
import type { Samples } from "../run/samples";
import { linesOf, TIME_PLOTS, times } from "./plots";

/** Spreadsheets read a file as UTF-8 only if it starts with this mark. */
const BYTE_ORDER_MARK = "\ufeff";

interface TableColumn {
  readonly title: string;
  readonly digits: number;
  readonly values: ArrayLike<number>;
}

/**
 * The measurements of a run as CSV, which a spreadsheet opens with a double click. Spreadsheets
 * expect the decimal point and the list separator of the language. One row per sample, 30 per
 * second, in metres, degrees and seconds, as on blocks.
 */
export function csvOf(samples: Samples, texts: Texts, language: Language): string {
  const comma = listSeparator(language);
  const point = decimalPoint(language);
  const columns = tableOf(samples, texts);
  const cell = ({ values, digits }: TableColumn, row: number) => {
    const value = values[row] ?? Number.NaN;
    return Number.isNaN(value) ? "" : plain(value, digits).replace(".", point);
  };
  const lines = [columns.map((column) => column.title).join(comma)];
  for (let row = 0; row < samples.rows; row++) {
    lines.push(columns.map((column) => cell(column, row)).join(comma));
  }
  return `${BYTE_ORDER_MARK}${lines.join("\r\n")}\r\n`;
}

/** Formats a number, never as "-0.0000". */
const plain = (value: number, digits: number) => {
  const text = value.toFixed(digits);
  return Number(text) === 0 ? (0).toFixed(digits) : text;
};

function tableOf(samples: Samples, { plots }: Texts): TableColumn[] {
  const title = (letter: string, role: keyof typeof plots.roles, unit: string) =>
    `${letter} ${plots.roles[role]} (${unit})`;
  const columns: TableColumn[] = [
    { title: `${plots.time} (s)`, digits: 3, values: times(samples) },
  ];
  for (const name of ["position", "heading", "speed", "turning"] as const) {
    const { unit } = TIME_PLOTS[name];
    for (const { letter, role, values } of linesOf(name, samples)) {
      columns.push({ title: title(letter, role, unit), digits: 4, values: values(samples) });
    }
  }
  return columns;
}
