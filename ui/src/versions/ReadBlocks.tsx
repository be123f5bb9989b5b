import { useEffect, useRef } from "preact/hooks";
import { BlocksViewer } from "../editor/reader/viewer";
import { language } from "../i18n";
import { theme } from "../shell/theme";

interface ReadBlocksProps {
  label: string;
  testId?: string;
  minTextPx?: (() => number) | undefined;
  /** Called with the reader when it is ready, and with null when it is disposed. */
  onReader(reader: BlocksViewer | null): void;
  /** Called when the language of the blocks changed. */
  onLanguage?(): void;
}

/** A read-only view of blocks. */
export function ReadBlocks({ label, testId, minTextPx, onReader, onLanguage }: ReadBlocksProps) {
  const container = useRef<HTMLDivElement>(null);
  const reader = useRef<BlocksViewer | null>(null);
  useEffect(() => {
    if (!container.current) return;
    const made = new BlocksViewer({
      container: container.current,
      language: language.peek(),
      theme: theme.peek(),
      mediaPath: "/media/",
      minTextPx,
    });
    reader.current = made;
    onReader(made);
    return () => {
      onReader(null);
      reader.current = null;
      made.dispose();
    };
  }, []);
  useEffect(() => reader.current?.setTheme(theme.value), [theme.value]);
  useEffect(() => {
    reader.current?.setLanguage(language.value);
    onLanguage?.();
  }, [language.value]);
  useEffect(() => reader.current?.setName(label), [label, language.value]);
  return <div class="blocks__editor" data-testid={testId} ref={container} />;
}
