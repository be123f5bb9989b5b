import { language, texts } from "../../i18n";
import { valueText } from "../values";

/** The current values of the program's variables. */
export function Watch({ rows }: { rows: readonly (readonly [string, unknown])[] }) {
  const { show } = texts.value;
  return (
    <div
      class="watch"
      // biome-ignore lint/a11y/noNoninteractiveTabindex: it scrolls, so the keyboard must reach it
      tabIndex={0}
    >
      <table class="watch__table" aria-label={show.variables} data-testid="watch">
        <thead class="visually-hidden">
          <tr>
            <th scope="col">{show.name}</th>
            <th scope="col">{show.value}</th>
          </tr>
        </thead>
        <tbody>
          {rows.map(([name, value]) => (
            <Row key={name} name={name} text={valueText(value, texts.value, language.value)} />
          ))}
        </tbody>
      </table>
    </div>
  );
}

function Row({ name, text }: { name: string; text: string }) {
  return (
    <tr>
      <th scope="row" title={name}>
        {name}
      </th>
      <td title={text} data-testid="watch-value" data-name={name}>
        {text}
      </td>
    </tr>
  );
}
