import { useEffect, useRef } from "preact/hooks";
import { theme } from "../app/theme";
import { BlocksReader } from "../editor/reader";
import { language } from "../i18n";

interface ReadBlocksProps {
  label: string;
  testId?: string;
  /** Hands the blocks over once they can be filled; null when they are gone. */
  onReader(reader: BlocksReader | null): void;
  /** The blocks speak another language now. */
  onLanguage?(): void;
}

/** A place for blocks to look at. */
export function ReadBlocks({ label, testId, onReader, onLanguage }: ReadBlocksProps) {
  const container = useRef<HTMLDivElement>(null);
  const reader = useRef<BlocksReader | null>(null);
  useEffect(() => {
    if (!container.current) return;
    const made = new BlocksReader({
      container: container.current,
      language: language.peek(),
      theme: theme.peek(),
      mediaPath: "/media/",
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
