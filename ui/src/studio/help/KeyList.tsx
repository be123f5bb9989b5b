import { saysAll, wordsOf } from "../../blocks/toolbox/search";
import { texts } from "../../i18n";
import { keyGroups } from "./keys";

/** The keys, or those whose words the query finds. */
export function KeyList({ query }: { query: string }) {
  const wanted = wordsOf(query);
  const says = (words: string) => saysAll(words, wanted);
  const groups = keyGroups(texts.value)
    .map(({ title, rows, more = [] }) => ({
      title,
      rows: rows.filter(({ keys, words }) => says(`${keys.join(" ")} ${words}`)),
      more: more.filter(says),
    }))
    .filter(({ rows, more }) => rows.length + more.length > 0);
  return (
    <>
      {groups.map(({ title, rows, more }) => (
        <section key={title} class="help__keys">
          <h2>{title}</h2>
          <dl>
            {rows.map(({ keys, words }) => (
              <div key={words}>
                <dt>
                  {keys.map((key) => (
                    <kbd key={key}>{key}</kbd>
                  ))}
                </dt>
                <dd>{words}</dd>
              </div>
            ))}
          </dl>
          {more.map((line) => (
            <p key={line}>{line}</p>
          ))}
        </section>
      ))}
    </>
  );
}
