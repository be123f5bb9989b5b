import { Copy, CopyCheck } from "lucide-preact";
import { useState } from "preact/hooks";
import { TEST } from "../app/testids";
import { texts } from "../i18n";
import { copyText } from "./copy";

const COPIED_MS = 2000;

/** The program document as the robot gets it. */
export function IrPanel({ document }: { document: object | null }) {
  const { ir } = texts.value;
  const [copied, setCopied] = useState(false);
  const text = document ? JSON.stringify(document, null, 2) : "";
  const copy = async () => {
    await copyText(text);
    setCopied(true);
    setTimeout(() => setCopied(false), COPIED_MS);
  };
  const Icon = copied ? CopyCheck : Copy;
  return (
    <section class="ir" aria-label={ir.tab}>
      <div class="ir__head">
        <p>{ir.explain}</p>
        <button
          type="button"
          class="button"
          data-testid={TEST.irCopy}
          disabled={!text}
          onClick={() => void copy()}
        >
          <Icon class="icon" aria-hidden="true" />
          <span aria-live="polite">{copied ? ir.copied : ir.copy}</span>
        </button>
      </div>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: it scrolls, so the keyboard must reach it */}
      <pre class="ir__text" tabIndex={0} data-testid={TEST.irJson}>
        {text ? tokens(text) : ir.empty}
      </pre>
    </section>
  );
}

const TOKEN = /("(?:[^"\\]|\\.)*")(\s*:)?|(-?\d+(?:\.\d+)?(?:e[-+]?\d+)?)/gi;

/** Names, texts and numbers in their own colours; no markup is ever made from the text itself. */
function tokens(text: string) {
  const parts: (string | preact.JSX.Element)[] = [];
  let end = 0;
  for (const match of text.matchAll(TOKEN)) {
    const [whole, quoted, colon] = match;
    parts.push(text.slice(end, match.index));
    const kind = quoted ? (colon ? "name" : "text") : "number";
    parts.push(<span class={`ir__token--${kind}`}>{quoted ?? whole}</span>, colon ?? "");
    end = match.index + whole.length;
  }
  parts.push(text.slice(end));
  return parts;
}
