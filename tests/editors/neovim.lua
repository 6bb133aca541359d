-- Run by try.py after the line of docs/editors.md, with scene.xml: what a writer of scenes does in Neovim.

local function check(holds, what)
  if not holds then
    io.stderr:write(what .. '\n')
    vim.cmd('cquit 1')
  end
end

local function find(text)
  for i, line in ipairs(vim.api.nvim_buf_get_lines(0, 0, -1, false)) do
    local at = line:find(text, 1, true)
    if at then
      return i, at - 1
    end
  end
end

local function params(line, column)
  vim.api.nvim_win_set_cursor(0, { line, column })
  return vim.lsp.util.make_position_params()
end

local function ask(method, what)
  for _, answer in pairs(vim.lsp.buf_request_sync(0, method, what, 10000) or {}) do
    check(not answer.err, method)
    return answer.result
  end
  check(false, method .. ': no answer')
end

local function findings(count)
  return vim.wait(10000, function() return #vim.diagnostic.get(0) == count end, 5)
end

vim.api.nvim_create_autocmd('VimEnter', { callback = function()
  check(findings(1), 'findings')
  local finding = vim.diagnostic.get(0)[1]
  local line, column = find('<difuse')
  check(finding.code == 'xml.misspelled-element' and finding.lnum == line - 1 and finding.col == column, 'place')

  line, column = find('position')
  check(#ask('textDocument/hover', params(line, column)).contents.value > 10, 'hover')
  line, column = find('id v=')
  check(ask('textDocument/completion', params(line, column))[1].label == 'id', 'completion')
  line, column = find('"master" name="leg"')
  local use = params(line, column + 16)
  check(ask('textDocument/definition', use).range.start.line == 2, 'definition')
  vim.lsp.buf.rename('foot')
  check(vim.wait(10000, function() return find('name="foot"') == 3 and not find('name="leg"') end, 5), 'rename')

  line, column = find('<difuse')
  params(line, column)
  local range = vim.lsp.util.make_range_params()
  range.context = { diagnostics = {} }
  local fix = ask('textDocument/codeAction', range)[1]
  vim.lsp.util.apply_workspace_edit(fix.edit, 'utf-16')
  check(find('<diffuse'), 'quick fix')
  check(findings(0), 'no findings')
  local formatted = ask('textDocument/formatting', { textDocument = range.textDocument, options = { tabSize = 2 } })
  vim.lsp.util.apply_text_edits(formatted, 0, 'utf-16')
  check(find('    <id v="0"/>') == 3, 'formatting')

  line, column = find('<diffuse')
  local before = vim.loop.hrtime()
  vim.api.nvim_buf_set_text(0, line - 1, column + 1, line - 1, column + 2, {})
  check(findings(1), 'findings of a change')
  io.stderr:write(string.format('tried: right; from a change to its findings %d ms\n', (vim.loop.hrtime() - before) / 1e6))
  vim.cmd('qall!')
end })
