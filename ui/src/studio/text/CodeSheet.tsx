import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { PYTHON_TOKENS, tokens } from "./tokens";

interface CodeSheetProps {
  text: string;
  /** The line that runs, counted from 1; it is kept in sight. */
  lit?: number | null;
  /** Lines with something to mend. */
  faulty?: ReadonlySet<number>;
  label: string;
  testId?: string;
  /** What lies over the text and takes the typing. */
  children?: ComponentChildren;
}

/** Lines around the running one that are kept in sight too. */
const AROUND = 2;

/** Python text with line numbers. */
export function CodeSheet({ text, lit = null, faulty, label, testId, children }: CodeSheetProps) {
  const sheet = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (sheet.current && lit !== null) showLine(sheet.current, lit);
  }, [lit, text]);
  const count = text.split("\n").length;
  return (
    <section
      class="code"
      ref={sheet}
      aria-label={label}
      data-scrolls
      // it scrolls, so the keyboard must reach it
      tabIndex={children ? -1 : 0}
      data-testid={testId}
      data-lit={lit ?? ""}
    >
      <div class="code__page">
        {lit !== null && <span class="code__lit" style={{ "--line": lit - 1 }} />}
        {[...(faulty ?? [])].map((line) => (
          <span key={line} class="code__faulty" style={{ "--line": line - 1 }} />
        ))}
        <pre class="code__numbers" aria-hidden="true">
          {Array.from({ length: count }, (_, index) => index + 1).join("\n")}
        </pre>
        <div class="code__text">
          {/* an empty last line has no height of its own */}
          <pre aria-hidden={children ? "true" : undefined}>
            {tokens(text, PYTHON_TOKENS)}
            {"\n"}
          </pre>
          {children}
        </div>
      </div>
    </section>
  );
}

/** Scrolls up or down until a line can be seen, no further. */
export function showLine(sheet: HTMLElement, line: number): void {
  const { lineHeight, paddingTop } = getComputedStyle(sheet);
  const height = Number.parseFloat(lineHeight) || 22;
  const top = Number.parseFloat(paddingTop) + (line - 1) * height;
  const lowest = top - AROUND * height;
  const highest = top + (1 + AROUND) * height - sheet.clientHeight;
  if (sheet.scrollTop > lowest) sheet.scrollTop = lowest;
  else if (sheet.scrollTop < highest) sheet.scrollTop = highest;
}
