/** Breaks a sentence into lines, because SVG text does not wrap automatically. */
export function wrapText(text: string, width = 34): string {
  const lines: string[] = [];
  for (const token of text.split(/\s+/)) {
    const line = lines.at(-1);
    if (line !== undefined && line.length + 1 + token.length <= width) {
      lines[lines.length - 1] = `${line} ${token}`;
    } else {
      lines.push(token);
    }
  }
  return lines.join("\n");
}
