import { Copy, CopyCheck } from "lucide-preact";
import { useState } from "preact/hooks";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { copyText } from "../../kit/clipboard";
import { JSON_TOKENS, tokens } from "./tokens";

const COPIED_MS = 2000;

/** The program document as JSON. */
export function IrPanel({ document }: { document: object | null }) {
  const { ir } = texts.value;
  const text = document ? JSON.stringify(document, null, 2) : "";
  return (
    <section class="text__panel column grows shrinks-down" aria-label={ir.tab}>
      <div class="text__bar row middle apart rigid gap-2">
        <p class="text__state row middle grows shrinks gap-2">{ir.explain}</p>
        <CopyButton text={text} />
      </div>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: it scrolls, so the keyboard must reach it */}
      <pre class="text__json grows shrinks-down" tabIndex={0} data-testid="ir-json">
        {text ? tokens(text, JSON_TOKENS) : ir.empty}
      </pre>
    </section>
  );
}

export function CopyButton({ text }: { text: string }) {
  const { ir } = texts.value;
  const [copied, setCopied] = useState(false);
  const copy = async () => {
    await copyText(text);
    setCopied(true);
    setTimeout(() => setCopied(false), COPIED_MS);
  };
  return (
    <Button icon={copied ? CopyCheck : Copy} testId="ir-copy" disabled={!text} onPress={copy}>
      <span aria-live="polite">{copied ? ir.copied : ir.copy}</span>
    </Button>
  );
}
