/** Examples, help about blocks and keys, and the guided first drive. */
export const help = {
  examples: {
    title: "Exemplos",
    hint: "Abrem como cópia: rodem, depois desmontem e mudem.",
  },
  search: "Procurar na ajuda",
  nothing: "Nada com essas palavras. Tentem outra.",
  tryIt: "Experimentar",
  tryItHelp: "Põe o bloco no programa",
  openExample: "Abrir uma cópia",
  moreInLevel: "Há mais blocos para isso em outro nível.",
  tabs: {
    tasks: "O que dá para fazer?",
    blocks: "Blocos",
    keys: "Teclas",
  },
  tasks: {
    drive: "Andar e virar",
    draw: "Desenhar no chão",
    sense: "Sentir o que há em volta",
    decide: "Decidir",
    repeat: "Repetir",
  },
  keys: {
    blocks: "Blocos",
    palette: "Ir para as categorias de blocos",
    program: "Ir para o programa",
    arrows: "Andar entre os blocos",
    enter: "Pôr o bloco; mudar um número",
    move: "Mover o bloco com as setas",
    remove: "Apagar o bloco",
    copy: "Copiar e colar",
    escape: "Sair do que está aberto",
    tab: "Ir para a próxima parte da tela",
  },
};
