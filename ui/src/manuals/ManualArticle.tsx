import { useLayoutEffect, useRef } from "preact/hooks";
import { texts } from "../i18n";
import { hashOf } from "../shell/route";
import { manualLanguage } from "./library";
import { ManualText } from "./ManualText";
import type { Manual, ManualSection } from "./model";

interface ManualArticleProps {
  manual: Manual;
  /** Id of the heading to show; null for the beginning. */
  section: string | null;
}

/** A manual, beside the list of its sections. */
export function ManualArticle({ manual, section }: ManualArticleProps) {
  const article = useRef<HTMLElement>(null);
  const show = (id: string) => {
    const heading = document.getElementById(id);
    if (!heading || !article.current?.contains(heading)) return;
    heading.scrollIntoView?.(); // jsdom has none
    heading.focus({ preventScroll: true });
  };
  useLayoutEffect(() => show(section ?? ""), [section]);
  return (
    <div class="manuals__article">
      <Contents manual={manual} onOpen={show} />
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: the text scrolls and may have nothing to focus */}
      <article ref={article} class="manual" tabIndex={0} lang={manualLanguage()}>
        <h1>{manual.title}</h1>
        {manual.sections.map((one) => (
          <Section key={one.id} section={one} />
        ))}
      </article>
    </div>
  );
}

interface ContentsProps {
  manual: Manual;
  /** Called with the id of a heading whose link was pressed, even if it is in the address already. */
  onOpen(id: string): void;
}

function Contents({ manual, onOpen }: ContentsProps) {
  return (
    <nav class="manuals__contents column gap-1" aria-label={texts.value.help.manuals.sections}>
      {manual.sections
        .filter(({ id }) => id)
        .map(({ id, title }) => (
          <a
            key={id}
            class="manuals__section"
            lang={manualLanguage()}
            href={hashOf({ screen: "manuals", manual: manual.name, section: id })}
            data-testid="manual-section"
            onClick={() => onOpen(id)}
          >
            {title}
          </a>
        ))}
    </nav>
  );
}

function Section({ section }: { section: ManualSection }) {
  return (
    <section>
      {section.title && (
        <h2 id={section.id} tabIndex={-1}>
          {section.title}
        </h2>
      )}
      <ManualText nodes={section.nodes} />
    </section>
  );
}
