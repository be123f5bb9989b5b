import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { PYTHON_TOKENS, tokens } from "./tokens";

interface CodeSheetProps {
  text: string;
  /** The running line, from 1; scrolled into view. */
  activeLine?: number | null;
  /** Lines with faults. */
  faulty?: ReadonlySet<number>;
  label: string;
  testId?: string;
  /** Overlay that receives the keyboard input. */
  children?: ComponentChildren;
}

/** Number of lines before and after the running line that stay visible. */
const AROUND = 2;

/** Python text with line numbers. */
export function CodeSheet({
  text,
  activeLine = null,
  faulty,
  label,
  testId,
  children,
}: CodeSheetProps) {
  const sheet = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (sheet.current && activeLine !== null) showLine(sheet.current, activeLine);
  }, [activeLine, text]);
  const count = text.split("\n").length;
  return (
    <section
      class="code grows shrinks-down"
      ref={sheet}
      aria-label={label}
      data-scrolls
      // scrollable, so it must be focusable
      tabIndex={children ? -1 : 0}
      data-testid={testId}
      data-lit={activeLine ?? ""}
    >
      <div class="code__page">
        {activeLine !== null && <span class="code__lit" style={{ "--line": activeLine - 1 }} />}
        {[...(faulty ?? [])].map((line) => (
          <span key={line} class="code__faulty" style={{ "--line": line - 1 }} />
        ))}
        <pre class="code__numbers" aria-hidden="true">
          {Array.from({ length: count }, (_, index) => index + 1).join("\n")}
        </pre>
        <div class="code__text">
          {/* an empty last line has no height */}
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

/** Scrolls just far enough to show a line. */
export function showLine(sheet: HTMLElement, line: number): void {
  const { lineHeight, paddingTop } = getComputedStyle(sheet);
  const height = Number.parseFloat(lineHeight) || 22;
  const top = Number.parseFloat(paddingTop) + (line - 1) * height;
  const lowest = top - AROUND * height;
  const highest = top + (1 + AROUND) * height - sheet.clientHeight;
  if (sheet.scrollTop > lowest) sheet.scrollTop = lowest;
  else if (sheet.scrollTop < highest) sheet.scrollTop = highest;
}
